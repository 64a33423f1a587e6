// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

namespace vkbake::cli {

[[nodiscard]] std::string duration_text(double seconds);   ///< "0.42 s", "3:07", "1:02:33"
[[nodiscard]] std::string count_text(double count);        ///< "812", "17.4 k", "3.1 M", "2.0 G"
[[nodiscard]] std::string bytes_text(std::uint64_t bytes); ///< "812 MiB", "17.4 GiB"
[[nodiscard]] std::string grouped(std::uint64_t count);    ///< "1,234,567"
[[nodiscard]] std::string plural(std::uint64_t count, const std::string& one,
                                 const std::string& many); ///< "1 chart", "2 charts"

} // namespace vkbake::cli
