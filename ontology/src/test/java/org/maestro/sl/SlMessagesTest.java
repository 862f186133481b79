package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is refused, and the whole sentence in which it is. */
class SlMessagesTest {

  private static final String A_NAME = "a name of letters, digits and . _ - @ % +";

  private static void isRefused(Runnable reading, int column, String expected, String found) {
    assertThatThrownBy(reading::run)
        .isInstanceOf(SlSyntaxException.class)
        .hasMessage(
            "At column %d %s was expected, but found %s.".formatted(column, expected, found));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        ") | 1 | a formula | \")\"",
        "( ) | 1 | a formula | \"()\"",
        "(a | 3 | the \")\" for the \"(\" at column 1 | the end of the text",
        "(a) (b) | 5 | the end of the text | \"(\"",
        "(not \"x\") | 6 | a formula | the string \"x\"",
        "(not <x>) | 6 | a formula | \"<x>\"",
        "(not ?x) | 6 | a formula | \"?x\"",
        "(in Cup +) | 9 | a term | \"+\"",
        "(not) | 5 | a formula | \")\"",
        "(keep) | 6 | a formula | \")\"",
        "(keep (a) (b)) | 11 | \")\" | \"(b ...)\"",
        "(imply (a)) | 11 | a formula | \")\"",
        "(imply (a) (b) (c)) | 16 | \")\" | \"(c ...)\"",
        "(exists (?x)) | 13 | variables and a formula | \")\"",
        "(exists (?x) (a) (b)) | 18 | \")\" | \"(b ...)\"",
        "(forall (?x)) | 13 | variables and a formula | \")\"",
        "(forall (?x) (a) (b)) | 18 | \")\" | \"(b ...)\"",
        "(exists (?x \"-\" Thing) (a)) | 13 | a variable such as ?x | the string \"-\"",
        "(exists (?x <-> Thing) (a)) | 13 | a variable such as ?x | \"<->\"",
        "(> (+) 1) | 6 | a number | \")\"",
        "(> 1 -1e999) | 6 | a number between -1.8e308 and 1.8e308 | \"-1e999\"",
      })
  void aFaultyFormula(String text, int column, String expected, String found) {
    isRefused(() -> SlParser.formula(text), column, expected, found);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "(not) | 5 | an atom | \")\"",
        "(not (a) (b)) | 10 | \")\" | \"(b ...)\"",
        "(forall (?x)) | 13 | variables and an effect | \")\"",
        "(forall (?x) (a) (b)) | 18 | \")\" | \"(b ...)\"",
        "(increase (level l)) | 20 | a fluent and a number | \")\"",
        "(increase (level l) 1 2) | 23 | \")\" | \"2\"",
      })
  void aFaultyEffect(String text, int column, String expected, String found) {
    isRefused(() -> SlParser.effect(text), column, expected, found);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "Cup | 1 | a fact such as (in Cup zone-a) or (= (level lamp-1) 0.5) | \"Cup\"",
        "(not) | 5 | an atom | \")\"",
        "(not (a) (b)) | 10 | \")\" | \"(b ...)\"",
        "(unknown) | 9 | an atom or a fluent | \")\"",
        "(unknown (a) (b)) | 14 | \")\" | \"(b ...)\"",
        "(= (f)) | 7 | a fluent and its value | \")\"",
        "(= (f) 1 2) | 10 | \")\" | \"2\"",
      })
  void aFaultyFact(String text, int column, String expected, String found) {
    isRefused(() -> SlParser.fact(text), column, expected, found);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "\"zone | 6 | the '\"' that ends the string of column 1 | the end of the text",
        "\"a\\nb\" | 3 | \\\" or \\\\ | \"\\n\"",
        "\"a\\ | 3 | \\\" or \\\\ | \"\\\"",
        "<http://a | 10 | the \">\" that ends the IRI of column 1 | the end of the text",
        "<a b> | 3 | the \">\" that ends the IRI of column 1 | \" \"",
        "<a<b> | 3 | the \">\" that ends the IRI of column 1 | \"<\"",
        "<a\"b> | 3 | the \">\" that ends the IRI of column 1 | \"\"\"",
        "< | 1 | a term | \"<\"",
        "<= | 1 | a term | \"<=\"",
        ":zone | 1 | a term | \":zone\"",
      })
  void aFaultyTerm(String text, int column, String expected, String found) {
    isRefused(() -> SlParser.term(text), column, expected, found);
    isRefused(
        () -> SlParser.term("   " + text),
        column + 3,
        expected.replace("column 1", "column 4"),
        found);
  }

  @ParameterizedTest
  @CsvSource({"?", ":", ".", "-.", "+.e1", "--5", "?-", "a!"})
  void aWordThatIsNoName(String word) {
    isRefused(() -> SlParser.fact("(in " + word + " a)"), 5, A_NAME, "\"" + word + "\"");
  }

  @Test
  void aFaultyVariable() {
    isRefused(() -> SlParser.variable("?x -"), 5, "a class name", "the end of the text");
    isRefused(() -> SlParser.variable("?x ?y"), 1, "one variable", "2 variables");
    isRefused(() -> SlParser.variable("Thing"), 1, "a variable such as ?x", "\"Thing\"");
  }

  @Test
  void faultyContent() {
    String element = "a content element such as (initCNP ...)";
    isRefused(() -> SlParser.content("\"\""), 3, element, "the end of the text");
    isRefused(() -> SlParser.content("(cancel G1) )"), 13, element, "\")\"");
  }

  @Test
  void theFormulasFaultWhereTheEffectHasTheSame() {
    isRefused(() -> SlParser.content("(inform (and d))"), 14, "a formula", "\"d\"");
  }

  @Test
  void whatWasExpectedIsToldApartToo() {
    SlSyntaxException fault =
        catchThrowableOfType(SlSyntaxException.class, () -> SlParser.formula("(not Cup)"));
    assertThat(fault.expected()).isEqualTo("a formula");
  }
}
