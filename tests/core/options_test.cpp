#include "core/text/options.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

const std::vector<OptionKey> keys = {
    {.name = "n", .type = OptionKey::Type::integer, .min = 1},
    {.name = "nu", .min = 0, .max = 1, .min_open = true, .max_open = true},
    {.name = "order", .type = OptionKey::Type::word, .words = {"leja", "natural"}},
};

std::string complaint(const std::string& spec) {
  return test::message_of<UsageError>([&] { Options(parse_spec(spec), keys); });
}

TEST(Spec, SplitsNameAndSettings) {
  const Options options(parse_spec("sts:n=20,nu=1e-4,order=leja"), keys);
  EXPECT_EQ(options.spec().name, "sts");
  EXPECT_EQ(options.spec().parameters(), "n=20,nu=1e-4,order=leja");
  EXPECT_EQ(options.integer("n"), 20);
  EXPECT_EQ(options.number("nu"), 1e-4);
  EXPECT_EQ(options.word("order"), "leja");
  EXPECT_EQ(options.given("step"), std::nullopt);
}

TEST(Spec, NamesValueRangeAndNearestKey) {
  EXPECT_NE(complaint("sts:nu=0").find("0 < nu < 1"), std::string::npos);
  EXPECT_NE(complaint("sts:nu=1").find("'1'"), std::string::npos);
  EXPECT_NE(complaint("sts:n=0").find("n >= 1"), std::string::npos);
  EXPECT_NE(complaint("sts:n=2.5").find("integer"), std::string::npos);
  EXPECT_NE(complaint("sts:ordr=leja").find("did you mean 'order'"), std::string::npos);
  EXPECT_NE(complaint("sts:order=lejja").find("did you mean 'leja'"), std::string::npos);
  EXPECT_NE(complaint("sts:n=99999999999").find("n >= 1"), std::string::npos);
}

TEST(Spec, RefusesMalformedText) {
  for (const char* spec : {"", ":n=1", "sts:", "sts:n", "sts:n=", "sts:=1", "sts:n=1,n=2", "sts:n=1,"})
    EXPECT_THROW(static_cast<void>(parse_spec(spec)), UsageError) << spec;
}

TEST(Spec, ExclusiveKeys) {
  const Options options(parse_spec("sts:n=2,nu=0.5"), keys);
  const std::vector<std::string> both = {"n", "nu"};
  EXPECT_THROW(options.at_most_one_of(both), UsageError);
}

TEST(Specs, WordsAreListedOnce) {
  const std::vector<OptionKey> n = {
      {.name = "n", .type = OptionKey::Type::integer, .min = 1, .words = {"auto"}}};
  const auto message = test::message_of<UsageError>([&] { Options(parse_spec("sts:n=0"), n); });
  EXPECT_NE(message.find("n >= 1 or auto"), std::string::npos) << message;
  EXPECT_EQ(message.find("valid are"), std::string::npos) << message;
  EXPECT_NE(complaint("sts:order=leia").find("did you mean 'leja'"), std::string::npos);
}

TEST(Specs, SeveralInOneAreToldApart) {
  const auto message = test::message_of<UsageError>([] { (void)parse_spec("rkc,rkl"); });
  EXPECT_NE(message.find("several integrators are given apart"), std::string::npos) << message;
}

TEST(Specs, ThatSayTheSameAreFoundInAnyOrderOfSettings) {
  using List = std::vector<std::string>;
  EXPECT_EQ(repeated_spec(List{"rkc", "cvode", "rkc"}), "rkc");
  EXPECT_EQ(repeated_spec(List{"sts:n=5,nu=0.1", "sts:nu=0.1,n=5"}), "sts:nu=0.1,n=5");
  EXPECT_EQ(repeated_spec(List{"rkc", "rkc:rtol=1e-3", "rkc:rtol=1e-4", "rkl"}), "");
}

}  // namespace
}  // namespace superstep
