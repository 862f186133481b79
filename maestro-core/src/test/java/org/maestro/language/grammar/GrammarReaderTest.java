package org.maestro.language.grammar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A grammar's file is read line by line, and what cannot be read is told with its line. */
class GrammarReaderTest {
  private static Grammar read(String... lines) {
    return GrammarReader.read("language xx\n" + String.join("\n", lines), "xx.grammar");
  }

  private static List<String> rules(String... lines) {
    return read(lines).rules().stream().map(GrammarReaderTest::written).toList();
  }

  private static String written(Rule rule) {
    return rule.category() + " " + rule.symbols().stream().map(GrammarReaderTest::text).toList();
  }

  private static String text(Symbol symbol) {
    return symbol instanceof Symbol.Category category
        ? category.name()
        : ((Symbol.Word) symbol).text();
  }

  private static Form meaning(Grammar grammar) {
    Rule rule = grammar.rules().get(0);
    return rule.template()
        .apply(
            label ->
                rule.labels().contains(label)
                    ? Optional.of(Form.leaf(label.toUpperCase(Locale.ROOT)))
                    : Optional.empty())
        .orElseThrow();
  }

  @Test
  void aPatternIsARuleOfWhichConstructionsMakeTheirs() {
    Grammar grammar =
        read("pattern Vp = VERB.base REST PARTICLE", "pattern Act = nicht REST VERB -> (no FRAME)");

    assertThat(grammar.rules()).isEmpty();
    assertThat(grammar.patterns())
        .extracting(GrammarReaderTest::written)
        .containsExactly("Vp [VERB.base, REST, PARTICLE]", "Act [nicht, REST, VERB]");
    assertThat(grammar.patterns())
        .extracting(pattern -> pattern.template().toString())
        .allMatch(template -> template.contains(ConstructionPlaces.FRAME));
  }

  @Test
  void aRuleHasItsSymbolsAndItsLabels() {
    Rule rule = read("Act = bring o:Thing to w:Who -> (do (bring o w))").rules().get(0);

    assertThat(rule.category()).isEqualTo("Act");
    assertThat(rule.symbols())
        .containsExactly(
            new Symbol.Word("bring"),
            new Symbol.Category("Thing"),
            new Symbol.Word("to"),
            new Symbol.Category("Who"));
    assertThat(rule.labels()).containsExactly("", "o", "", "w");
    assertThat(rule.penalty()).isZero();
  }

  @Test
  void alternativesAndWhatMayBeLeftOutAreRulesOfTheirOwn() {
    assertThat(rules("Act = go/run the? -> (go)"))
        .containsExactly("Act [go, the]", "Act [go]", "Act [run, the]", "Act [run]");
    assertThat(rules("Act = Cat/Dog? now"))
        .containsExactly("Act [Cat, now]", "Act [Dog, now]", "Act [now]");
    assertThat(rules("Act = a_b/c")).containsExactly("Act [a, b]", "Act [c]");
  }

  @Test
  void aRuleOfWhichAllMayBeLeftOutIsNoneOfNoWords() {
    assertThat(rules("Act = go? -> (go)")).containsExactly("Act [go]");
  }

  @Test
  void aPenaltyStandsAtTheEnd() {
    assertThat(read("Act = go -> (go) !3").rules().get(0).penalty()).isEqualTo(3);
    assertThat(read("Act = Cat !2").rules().get(0).penalty()).isEqualTo(2);
  }

  @Test
  void aMeaningNamesPartsByTheirLabels() {
    assertThat(meaning(read("Act = go w:Where -> (do (go w) now)"))).hasToString("(do (go W) now)");
    assertThat(meaning(read("Act = go w:Where -> w"))).hasToString("W");
    assertThat(meaning(read("Act = go w:Where"))).hasToString("W");
    assertThat(meaning(read("Act = go Where"))).hasToString("WHERE");
    assertThat(meaning(read("Act = go"))).hasToString("word");
  }

  @Test
  void otherLinesHaveTheirKeyword() {
    Grammar grammar =
        read(
            "number two = 2",
            "times dozen = 12",
            "list filler = uh, you know",
            "list filler = comma",
            "phrase none = I know no {what}.",
            "spelling can't = can not");

    assertThat(grammar.language()).isEqualTo("xx");
    assertThat(grammar.numbers()).containsExactly(Map.entry("two", 2.0));
    assertThat(grammar.times()).containsExactly(Map.entry("dozen", 12.0));
    assertThat(grammar.list("filler"))
        .isEqualTo(Set.of(List.of("uh"), List.of("you", "know"), List.of(",")));
    assertThat(grammar.list("other")).isEmpty();
    assertThat(grammar.phrase("none")).isEqualTo("I know no {what}.");
    assertThat(grammar.spellings()).containsEntry("can't", "can not");
    assertThatThrownBy(() -> grammar.phrase("which"))
        .hasMessageContaining("xx has no phrase which");
  }

  @Test
  void remarksAndEmptyLinesSayNothing() {
    assertThat(rules("", "# Act = no", "  Act = go # = stay", "\t", "Act = see\r"))
        .containsExactly("Act [go]", "Act [see]");
  }

  @Test
  void moreRulesComeAfterItsOwn() {
    Grammar grammar = read("Act = go");
    Grammar more = grammar.with(read("Act = see").rules());

    assertThat(more.rules().stream().map(GrammarReaderTest::written))
        .containsExactly("Act [go]", "Act [see]");
    assertThat(grammar.rules()).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "act = go | begins with act | write a rule such as",
        "Act = | begins with Act | write a rule such as",
        "Act = -> (go) | has no items before its -> | between = and ->",
        "Act = / | / is no item | write a word or a Category",
        "Act = a: | a: is no item | write a word or a Category",
        "Act = a:Cat b:Dog | does not say what it means | write -> and a form",
        "Act = go -> (do (go) | ends within a form | close each bracket",
        "Act = go -> ( | ends within a form | close each bracket",
        "Act = go -> (go) (go) | after its form | close no bracket twice",
        "Act = go -> (go)) | after its form | close no bracket twice",
        "Act = go !99999999999 | !99999999999 is too much | such as !2",
        "number two 2 | has no = in it | write the word, = and what it is",
        "number two = | has nothing beside its = | write the word, = and what it is",
        "spelling = can not | has nothing beside its = | write the word, = and what it is",
        "number two = zwei | zwei is no number | such as 20",
        "number all = Infinity | Infinity is no number | such as 20",
        "times dozen = a | a is no number | such as 20",
        "list filler | has no = in it | write the word",
        "list filler = uh,, um | a comma with nothing beside it | write comma",
        "ending plural | is no ending | write its form, a pattern",
        "ending plural a b c | is no ending | write its form, a pattern",
        "ending plural ( s | ( is no pattern | a regular expression such as",
        "ending plural (y)$ $2ies | $2ies names no group of (y)$ | write $1",
        "ending plural y$ $ | $ names no group of y$ | write $1",
        "irregular plural = mouse | mouse is no pair of words | write put put",
        "irregular plural = | has nothing beside its = | what it is",
        "pattern go | is no pattern | write one such as pattern Vp = VERB REST",
        "verb go | begins with verb | write a rule such as",
      })
  void whatCannotBeReadIsToldWithItsLineAndItsCure(String line, String cause, String cure) {
    assertThatThrownBy(() -> read("# a remark", "Act = go", line, "Act = see"))
        .isInstanceOf(GrammarFaultException.class)
        .hasMessageStartingWith("xx.grammar:4: ")
        .hasMessageContaining(cause)
        .hasMessageContaining(cure)
        .hasMessageEndingWith(".");
  }

  @Test
  void aGrammarNamesItsLanguage() {
    assertThatThrownBy(() -> GrammarReader.read("Act = go\n", "xx.grammar"))
        .isInstanceOf(GrammarFaultException.class)
        .hasMessage("xx.grammar:2: names no language; write a line such as language en.");
  }
}
