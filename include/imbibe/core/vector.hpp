// Small vectors and tensors over any number type: double, a pack of lanes, or one number of it.
//
// Eigen is the algebra of everything outside the pair loop (geometry, host views, decompositions). Inside the pair
// loop the numbers are packs and every term is run once at compile time to see what it reads, which Eigen 3.4 cannot
// do: these few types can. to_eigen/from_eigen cross the border.
#pragma once

#include <imbibe/core/pack_functions.hpp>

#include <Eigen/Core>

#include <array>
#include <type_traits>

namespace imbibe {

/// A vector of n numbers of type T.
template <class T, int n>
struct Vector {
    using Scalar = T;
    static constexpr int size = n;
    T c[static_cast<std::size_t>(n)];

    IMBIBE_INLINE constexpr T& operator[](int i) { return c[i]; }
    IMBIBE_INLINE constexpr const T& operator[](int i) const { return c[i]; }
    static constexpr Vector zero() { return filled(T(0)); }
    /// The same number in every component.
    static constexpr Vector filled(T x) {
        Vector v{};
        for (int i = 0; i < n; ++i)
            v.c[i] = x;
        return v;
    }
};

/// An n x n tensor of numbers of type T, row by row.
template <class T, int n>
struct Tensor {
    using Scalar = T;
    static constexpr int size = n * n;
    T c[static_cast<std::size_t>(n * n)];

    IMBIBE_INLINE constexpr T& operator()(int i, int j) { return c[i * n + j]; }
    IMBIBE_INLINE constexpr const T& operator()(int i, int j) const { return c[i * n + j]; }
    IMBIBE_INLINE constexpr T& operator[](int k) { return c[k]; }
    IMBIBE_INLINE constexpr const T& operator[](int k) const { return c[k]; }
    static constexpr Tensor zero() {
        Tensor t{};
        for (int k = 0; k < size; ++k)
            t.c[k] = T(0);
        return t;
    }
};

/// A symmetric n x n tensor: n (n + 1) / 2 numbers, in the order xx xy yy (2D) or xx xy xz yy yz zz (3D).
template <class T, int n>
struct SymmetricTensor {
    using Scalar = T;
    static constexpr int size = n * (n + 1) / 2;
    T c[static_cast<std::size_t>(size)];

    /// Where component (i, j) is stored.
    static constexpr int index(int i, int j) { return i <= j ? i * n - i * (i - 1) / 2 + (j - i) : index(j, i); }
    IMBIBE_INLINE constexpr T& operator()(int i, int j) { return c[index(i, j)]; }
    IMBIBE_INLINE constexpr const T& operator()(int i, int j) const { return c[index(i, j)]; }
    IMBIBE_INLINE constexpr T& operator[](int k) { return c[k]; }
    IMBIBE_INLINE constexpr const T& operator[](int k) const { return c[k]; }
    static constexpr SymmetricTensor zero() {
        SymmetricTensor t{};
        for (int k = 0; k < size; ++k)
            t.c[k] = T(0);
        return t;
    }
};

namespace detail {
template <class A>
inline constexpr int dimension_of = 0;
template <class T, int n>
inline constexpr int dimension_of<Vector<T, n>> = n;
template <class T, int n>
inline constexpr int dimension_of<Tensor<T, n>> = n;
template <class T, int n>
inline constexpr int dimension_of<SymmetricTensor<T, n>> = n;
template <class A>
concept Algebraic = dimension_of<std::remove_cvref_t<A>> > 0;
} // namespace detail

// Sums, differences and multiples mean the same for vectors and tensors: component by component.
template <detail::Algebraic A>
IMBIBE_INLINE constexpr A operator+(A a, const A& b) {
    for (int k = 0; k < A::size; ++k)
        a.c[k] = a.c[k] + b.c[k];
    return a;
}
template <detail::Algebraic A>
IMBIBE_INLINE constexpr A operator-(A a, const A& b) {
    for (int k = 0; k < A::size; ++k)
        a.c[k] = a.c[k] - b.c[k];
    return a;
}
template <detail::Algebraic A>
IMBIBE_INLINE constexpr A operator-(A a) {
    for (int k = 0; k < A::size; ++k)
        a.c[k] = -a.c[k];
    return a;
}
template <detail::Algebraic A>
IMBIBE_INLINE constexpr A operator*(const typename A::Scalar& s, A a) {
    for (int k = 0; k < A::size; ++k)
        a.c[k] = s * a.c[k];
    return a;
}
template <detail::Algebraic A>
IMBIBE_INLINE constexpr A operator*(const A& a, const typename A::Scalar& s) {
    return s * a;
}
template <detail::Algebraic A>
IMBIBE_INLINE constexpr A operator/(const A& a, const typename A::Scalar& s) {
    return (typename A::Scalar(1) / s) * a;
}
template <detail::Algebraic A>
IMBIBE_INLINE constexpr A& operator+=(A& a, const A& b) {
    return a = a + b;
}
template <detail::Algebraic A>
IMBIBE_INLINE constexpr A& operator-=(A& a, const A& b) {
    return a = a - b;
}

/// Scalar product.
template <class T, int n>
IMBIBE_INLINE constexpr T dot(const Vector<T, n>& a, const Vector<T, n>& b) {
    T s = a[0] * b[0];
    for (int i = 1; i < n; ++i)
        s = s + a[i] * b[i];
    return s;
}
/// |a|^2
template <class T, int n>
IMBIBE_INLINE constexpr T squared_norm(const Vector<T, n>& a) {
    return dot(a, a);
}
/// |a|
template <class T, int n>
IMBIBE_INLINE constexpr T norm(const Vector<T, n>& a) {
    return sqrt(dot(a, a));
}
/// The tensor a b^T.
template <class T, int n>
IMBIBE_INLINE constexpr Tensor<T, n> outer(const Vector<T, n>& a, const Vector<T, n>& b) {
    Tensor<T, n> t{};
    IMBIBE_UNROLL
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            t(i, j) = a[i] * b[j];
    return t;
}
/// The identity tensor.
template <class T, int n>
constexpr Tensor<T, n> identity() {
    auto t = Tensor<T, n>::zero();
    for (int i = 0; i < n; ++i)
        t(i, i) = T(1);
    return t;
}
/// The identity as a symmetric tensor.
template <class T, int n>
constexpr SymmetricTensor<T, n> symmetric_identity() {
    auto t = SymmetricTensor<T, n>::zero();
    for (int i = 0; i < n; ++i)
        t(i, i) = T(1);
    return t;
}

/// sum_j t_ij v_j.
template <class T, int n>
IMBIBE_INLINE constexpr Vector<T, n> operator*(const Tensor<T, n>& t, const Vector<T, n>& v) {
    Vector<T, n> r{};
    IMBIBE_UNROLL
    for (int i = 0; i < n; ++i) {
        r[i] = t(i, 0) * v[0];
        for (int j = 1; j < n; ++j)
            r[i] = r[i] + t(i, j) * v[j];
    }
    return r;
}
/// sum_j t_ij v_j.
template <class T, int n>
IMBIBE_INLINE constexpr Vector<T, n> operator*(const SymmetricTensor<T, n>& t, const Vector<T, n>& v) {
    Vector<T, n> r{};
    IMBIBE_UNROLL
    for (int i = 0; i < n; ++i) {
        r[i] = t(i, 0) * v[0];
        for (int j = 1; j < n; ++j)
            r[i] = r[i] + t(i, j) * v[j];
    }
    return r;
}
/// sum_k a_ik b_kj.
template <class T, int n>
IMBIBE_INLINE constexpr Tensor<T, n> operator*(const Tensor<T, n>& a, const Tensor<T, n>& b) {
    Tensor<T, n> r{};
    IMBIBE_UNROLL
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            r(i, j) = a(i, 0) * b(0, j);
            for (int k = 1; k < n; ++k)
                r(i, j) = r(i, j) + a(i, k) * b(k, j);
        }
    return r;
}
/// Rows become columns.
template <class T, int n>
IMBIBE_INLINE constexpr Tensor<T, n> transpose(const Tensor<T, n>& t) {
    Tensor<T, n> r{};
    IMBIBE_UNROLL
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            r(i, j) = t(j, i);
    return r;
}
/// The sum of the diagonal.
template <class A>
    requires(detail::dimension_of<A> > 0)
IMBIBE_INLINE constexpr typename A::Scalar trace(const A& t) {
    auto s = t(0, 0);
    for (int i = 1; i < detail::dimension_of<A>; ++i)
        s = s + t(i, i);
    return s;
}
/// (t + t^T) / 2
template <class T, int n>
IMBIBE_INLINE constexpr SymmetricTensor<T, n> symmetric_part(const Tensor<T, n>& t) {
    SymmetricTensor<T, n> s{};
    IMBIBE_UNROLL
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j)
            s(i, j) = T(0.5) * (t(i, j) + t(j, i));
    return s;
}
/// (t - t^T) / 2
template <class T, int n>
IMBIBE_INLINE constexpr Tensor<T, n> antisymmetric_part(const Tensor<T, n>& t) {
    Tensor<T, n> s{};
    IMBIBE_UNROLL
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            s(i, j) = T(0.5) * (t(i, j) - t(j, i));
    return s;
}
/// All components of a symmetric tensor.
template <class T, int n>
IMBIBE_INLINE constexpr Tensor<T, n> full(const SymmetricTensor<T, n>& s) {
    Tensor<T, n> t{};
    IMBIBE_UNROLL
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            t(i, j) = s(i, j);
    return t;
}
/// The sum of the products of all components, A:B, of symmetric tensors.
template <class T, int n>
IMBIBE_INLINE constexpr T dot(const SymmetricTensor<T, n>& a, const SymmetricTensor<T, n>& b) {
    T diagonal = a(0, 0) * b(0, 0), off = T(0);
    IMBIBE_UNROLL
    for (int i = 1; i < n; ++i) {
        diagonal += a(i, i) * b(i, i);
        for (int j = 0; j < i; ++j)
            off += a(j, i) * b(j, i);
    }
    return diagonal + 2 * off;
}
/// The determinant, n = 1, 2 or 3.
template <class T, int n>
IMBIBE_INLINE constexpr T determinant(const Tensor<T, n>& t) {
    static_assert(n >= 1 && n <= 3);
    if constexpr (n == 1)
        return t(0, 0);
    else if constexpr (n == 2)
        return t(0, 0) * t(1, 1) - t(0, 1) * t(1, 0);
    else
        return t(0, 0) * (t(1, 1) * t(2, 2) - t(1, 2) * t(2, 1)) - t(0, 1) * (t(1, 0) * t(2, 2) - t(1, 2) * t(2, 0)) +
               t(0, 2) * (t(1, 0) * t(2, 1) - t(1, 1) * t(2, 0));
}
/// The transposed matrix of cofactors: t * adjugate(t) = determinant(t) * identity.
template <class T, int n>
IMBIBE_INLINE constexpr Tensor<T, n> adjugate(const Tensor<T, n>& t) {
    static_assert(n >= 1 && n <= 3);
    Tensor<T, n> r{};
    if constexpr (n == 1) {
        r(0, 0) = T(1);
    } else if constexpr (n == 2) {
        r(0, 0) = t(1, 1), r(0, 1) = -t(0, 1), r(1, 0) = -t(1, 0), r(1, 1) = t(0, 0);
    } else {
        IMBIBE_UNROLL
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) { // cyclic indices carry the sign of the cofactor
                const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
                r(i, j) = t(a, c) * t(b, d) - t(a, d) * t(b, c);
            }
    }
    return r;
}
/// The inverse; the caller answers for a determinant that is not zero.
template <class T, int n>
IMBIBE_INLINE constexpr Tensor<T, n> inverse(const Tensor<T, n>& t) {
    return adjugate(t) / determinant(t);
}

/// An Eigen vector as the library's own.
template <class T, int n, class Derived>
constexpr Vector<T, n> from_eigen(const Eigen::MatrixBase<Derived>& v) {
    Vector<T, n> r{};
    for (int i = 0; i < n; ++i)
        r[i] = T(v[i]);
    return r;
}
/// The library's own vector as an Eigen vector.
template <class T, int n>
Eigen::Matrix<T, n, 1> to_eigen(const Vector<T, n>& v) {
    Eigen::Matrix<T, n, 1> r;
    for (int i = 0; i < n; ++i)
        r[i] = v[i];
    return r;
}

} // namespace imbibe
