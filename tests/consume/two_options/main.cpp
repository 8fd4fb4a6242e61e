// Runs the parts that are linked to it, plain first; see two_options.cmake.
#ifdef WITH_plain
void print_plain();
#endif
#ifdef WITH_fast
void print_fast();
#endif

int main() {
#ifdef WITH_plain
    print_plain();
#endif
#ifdef WITH_fast
    print_fast();
#endif
}
