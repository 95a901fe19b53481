#include "app/server/common_passwords.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

// sorted, for the search below
constexpr std::array kCommon = std::to_array<std::string_view>({
    "!qaz2wsx",     "0123456789",   "0987654321",   "11223344",     "123123123",     "12341234",
    "12345678",     "123456789",    "1234567890",   "1234abcd",     "123qweasd",     "135792468",
    "147258369",    "159753258",    "1q2w3e4r",     "1q2w3e4r5t",   "1qaz1qaz",      "1qaz2wsx",
    "1qazxsw2",     "246813579",    "31415926",     "314159265",    "741852963",     "789456123",
    "87654321",     "987654321",    "a12345678",    "a1b2c3d4",     "aa123456",      "abc12345",
    "abcd1234",     "abcdefg1",     "abcdefgh",     "abcdefghi",    "abcdefghij",    "access123",
    "access14",     "admin123",     "admin1234",    "adminadmin",   "administrator", "alexander",
    "alexandra",    "arsenal1",     "asdfasdf",     "asdfghjk",     "asdfghjkl",     "autumn2025",
    "autumn2026",   "azertyui",     "azertyuiop",   "barcelona",    "baseball",      "baseball1",
    "basketball",   "batman123",    "benjamin",     "blink182",     "butterfly",     "cathedra",
    "cathedra1",    "cathedra123",  "catheter",     "catheter1",    "catheter123",   "changeme",
    "changeme1",    "changeme123",  "charlie1",     "cheese123",    "chelsea1",      "chocolate",
    "chocolate1",   "computer",     "computer1",    "contrasena",   "corvette",      "daniel123",
    "december",     "default1",     "demo1234",     "demodemo",     "doctor123",     "dragon123",
    "elizabeth",    "facebook",     "facebook1",    "february",     "ferrari1",      "football",
    "football1",    "garfield",     "google123",    "guest123",     "guestguest",    "guidewire",
    "guidewire1",   "harley123",    "hello123",     "hellohello",   "hospital",      "hospital1",
    "hospital123",  "iloveu123",    "iloveyou",     "iloveyou1",    "iloveyou2",     "instructor",
    "instructor1",  "internet",     "internet1",    "jennifer",     "jessica1",      "jordan23",
    "juventus",     "letmein1",     "letmein123",   "letmeinnow",   "linkedin",      "liverpool",
    "liverpool1",   "login123",     "lovelove",     "macintosh",    "marlboro",      "master123",
    "matthew1",     "medicine",     "medicine1",    "mercedes",     "metallica",     "michael1",
    "michelle",     "microsoft",    "midnight",     "minecraft",    "monkey123",     "motdepasse",
    "mustang1",     "mypassword",   "mypassword1",  "newpassword",  "nirvana1",      "november",
    "nurse123",     "p0o9i8u7",     "p@ssw0rd",     "p@ssword",     "pa55word",      "pass1234",
    "pass12345",    "passpass",     "passw0rd",     "password",     "password!",     "password1",
    "password1!",   "password12",   "password123",  "password123!", "password1234",  "password2",
    "password2024", "password2025", "password2026", "passwort",     "passwort1",     "pokemon1",
    "pokemon123",   "porsche911",   "princess",     "princess1",    "q1w2e3r4",      "q1w2e3r4t5",
    "qazwsx123",    "qazwsxedc",    "qweasdzxc",    "qweqweqwe",    "qwerty12",      "qwerty123",
    "qwerty1234",   "qwertyui",     "qwertyuiop",   "qwertzui",     "qwertzuiop",    "realmadrid",
    "rockstar",     "root1234",     "rootroot",     "samantha",     "samsung1",      "samsung123",
    "scooby123",    "secret123",    "secretsecret", "september",    "shadow123",     "slipknot",
    "snoopy123",    "spiderman",    "spring2025",   "spring2026",   "starwars",      "starwars1",
    "summer2023",   "summer2024",   "summer2025",   "summer2026",   "sunshine",      "sunshine1",
    "superman",     "superman1",    "surgeon1",     "surgery1",     "temp1234",      "temppass",
    "test1234",     "testing1",     "testing123",   "testtest",     "thepassword",   "tinkerbell",
    "trainee1",     "trainee123",   "trustno1",     "twitter1",     "user1234",      "useruser",
    "vascular",     "vascular1",    "victoria",     "welcome1",     "welcome12",     "welcome123",
    "whatever",     "whatever1",    "windows1",     "winter2023",   "winter2024",    "winter2025",
    "winter2026",   "youtube1",     "zaq12wsx",     "zaq1zaq1",     "zxcvbnm1",      "zxcvbnm123",
});
static_assert(std::is_sorted(kCommon.begin(), kCommon.end()));

}  // namespace

bool is_common_password(std::string_view lower_case) {
  return std::binary_search(kCommon.begin(), kCommon.end(), lower_case);
}

}  // namespace app
