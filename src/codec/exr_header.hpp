// What an EXR file announces, looked at before OpenEXR believes it.
#pragma once

#include <OpenImageIO/filesystem.h>

namespace vkbake {

/// Whether the file is as long as every attribute of its headers says it is, and the attributes are as long as their
/// types, channel lists, texts and previews as what they hold. OpenEXR gets memory for an attribute, up to 2 GiB,
/// before it finds that the file ends. Nothing else is judged here. Layout: openexr.com, "OpenEXR File Layout".
[[nodiscard]] bool holds_its_attributes(OIIO::Filesystem::IOProxy& file);

} // namespace vkbake
