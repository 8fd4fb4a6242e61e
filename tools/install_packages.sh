#!/bin/sh
# Installs the Debian packages that imbibe needs and that are not there yet, as root or through sudo.
# When nothing is missing it does nothing and needs neither.
#
#   sh tools/install_packages.sh               for the library, the examples and their pictures
#   sh tools/install_packages.sh tests         for the tests as well
#   sh tools/install_packages.sh clang         for a build with clang++ as well
#   sh tools/install_packages.sh benchmarks    for the benchmarks as well
#   sh tools/install_packages.sh docs          for the documentation site as well
#   sh tools/install_packages.sh browser       for a look at that site, and at its links, as well
#   sh tools/install_packages.sh studies       for tools/sponge_bars.py as well
#   sh tools/install_packages.sh pictures      for tools/render_space.py and its movies as well
#   sh tools/install_packages.sh view          for tools/view.py as well: three.js, into build-view/three
#   sh tools/install_packages.sh bare          for .ci/bare, which tries the README's commands on a bare Debian
set -eu

packages="g++ cmake ninja-build libeigen3-dev libcli11-dev catch2 python3-numpy python3-matplotlib"
view=
for group in "$@"; do
    case $group in
        tests) packages="$packages python3-vtk9 pkg-config zlib1g-dev libtiff-dev" ;;
        clang) packages="$packages clang libomp-dev libc++-dev libc++abi-dev" ;;
        benchmarks) packages="$packages libbenchmark-dev libnanoflann-dev valgrind python3-psutil" ;;
        docs) packages="$packages doxygen doxygen-awesome-css libjs-lunr python3-lunr" ;;
        browser) packages="$packages linkchecker chromium chromium-driver python3-selenium" ;;
        studies) packages="$packages python3-scipy" ;;
        pictures) packages="$packages python3-vtk9 xvfb xauth ffmpeg" ;;
        view)
            view=asked
            command -v npm > /dev/null || packages="$packages nodejs npm"
            ;;
        bare) packages="$packages debootstrap" ;;
        *) echo "$0: there is no group '$group'; the groups are: tests, clang, benchmarks, docs, browser, studies, pictures, view, bare" >&2; exit 2 ;;
    esac
done

# Three.js as it was published, which the checksum tells: four files and its licence.
three=0.184.0
three_sum=5c8c75278504ff31cedcd736e043b06c18f2cbf220ad7f85fbfaa1a08d3b3626
three_folder=$(dirname "$0")/../build-view/three
fetch_three() {
    if grep -qs "\"version\": \"$three\"" "$three_folder/package.json"; then
        return
    fi
    echo "Fetching three.js $three"
    rm -rf "$three_folder"
    mkdir -p "$three_folder"
    (
        cd "$three_folder" && npm pack --silent "three@$three" > /dev/null &&
            echo "$three_sum  three-$three.tgz" | sha256sum --check --quiet &&
            tar xzf "three-$three.tgz" --strip-components=1 package/LICENSE package/build/three.core.min.js \
                package/build/three.module.min.js package/examples/jsm/controls/OrbitControls.js package/package.json &&
            rm "three-$three.tgz"
    ) || { rm -rf "$three_folder"; echo "$0: cannot fetch three.js $three" >&2; exit 1; }
}
if [ -n "$view" ] && command -v npm > /dev/null; then
    fetch_three
    view=
fi

if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
    echo "$0: this system has no apt-get. Install what these Debian packages hold, then run the rest of the command:" >&2
    echo "    $packages" >&2
    exit 1
fi

missing=
for package in $packages; do
    dpkg-query --show --showformat '${db:Status-Status}\n' "$package" 2> /dev/null | grep -qx installed ||
        missing="$missing $package"
done
if [ -z "$missing" ]; then
    exit 0
fi

if [ "$(id -u)" = 0 ]; then
    as_root=
elif command -v sudo > /dev/null; then
    as_root=sudo
else
    echo "$0: needs root or sudo to install packages. Ask an administrator to run:" >&2
    echo "    apt-get update && apt-get install --no-install-recommends$missing" >&2
    exit 1
fi

install() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet --no-install-recommends "$@" $missing
}
update() {
    $as_root apt-get update --quiet
}

echo "Installing$missing"
# The package lists may be absent, or so old that they name files the server no longer has.
apt-get install --simulate --no-install-recommends $missing > /dev/null 2>&1 || update
install || { update && install; }
[ -z "$view" ] || fetch_three
