#include "result/sha256.h"

#include <array>
#include <fstream>
#include <memory>
#include <openssl/evp.h>

#include <vasorod/error.h>

namespace vasorod {
namespace {

using Digest = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;

Digest begin() {
  Digest context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr);
  return context;
}

std::string end(const Digest& context) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_DigestFinal_ex(context.get(), digest.data(), &size);
  constexpr const char* digits = "0123456789abcdef";
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) {
    hex += digits[digest[i] >> 4];
    hex += digits[digest[i] & 15];
  }
  return hex;
}

}  // namespace

std::string sha256_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(file.string() + ": found no readable file, expected an input of the scene");
  const Digest context = begin();
  std::array<char, 65536> block{};
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
    EVP_DigestUpdate(context.get(), block.data(), static_cast<size_t>(stream.gcount()));
  return end(context);
}

std::string sha256_of_text(std::string_view text) {
  const Digest context = begin();
  EVP_DigestUpdate(context.get(), text.data(), text.size());
  return end(context);
}

}  // namespace vasorod
