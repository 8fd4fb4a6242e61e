# Compressed images need zlib and libtiff.
find_package(ZLIB REQUIRED)
find_package(TIFF REQUIRED)
target_link_libraries(test_input PRIVATE ZLIB::ZLIB TIFF::TIFF)
