# What every target of Parti has in common, and the two ways to declare one.

add_library(parti_options INTERFACE)
target_compile_features(parti_options INTERFACE cxx_std_20)
target_include_directories(parti_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(parti_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough
  -Werror
  # g++ 12 sees overlapping copies in std::string's assignment that aren't there (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # The same bytes on every machine: no fused multiply-add that only some processors have.
  -ffp-contract=off
  # Nor do bytes depend on where the project lies.
  -ffile-prefix-map=${CMAKE_SOURCE_DIR}/=)
if(PARTI_SANITIZE)
  target_compile_options(parti_options INTERFACE -fsanitize=address,undefined
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(parti_options INTERFACE -fsanitize=address,undefined)
endif()
if(PARTI_SANITIZE_THREADS)
  target_compile_options(parti_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer
    # It does not understand the fences in which a library's header orders what it never shares.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
  target_link_options(parti_options INTERFACE -fsanitize=thread)
endif()
if(PARTI_FUZZ)
  target_compile_options(parti_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# parti_library(FOLDER libraries…): all sources of this folder as the static library parti_FOLDER.
function(parti_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  list(FILTER sources EXCLUDE REGEX "/main\\.cc$")
  add_library(parti_${name} STATIC ${sources})
  target_link_libraries(parti_${name} PUBLIC parti_options ${ARGN})
endfunction()

# parti_test(FOLDER libraries…): tests/FOLDER/*.cc and tests/FOLDER/*/*_test.cc as one GoogleTest
# program.
function(parti_test name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cc
    ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*/*_test.cc)
  if(NOT sources)
    return()
  endif()
  add_executable(parti_${name}_tests ${sources})
  target_link_libraries(parti_${name}_tests PRIVATE parti_options parti_test_support ${ARGN}
    GTest::gmock GTest::gtest GTest::gtest_main rapidcheck)
  gtest_discover_tests(parti_${name}_tests DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 300 SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endfunction()
