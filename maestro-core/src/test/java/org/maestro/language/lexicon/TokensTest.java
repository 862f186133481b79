package org.maestro.language.lexicon;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Texts are taken apart into words, whatever stands in them. */
class TokensTest {
  private static final Tokens TOKENS =
      new Tokens(
          Map.of(
              "can't",
              "can not",
              "%",
              "percent",
              "°c",
              "degrees celsius",
              "~'s",
              "~ 's",
              "~s'",
              "~s 's"));

  private static List<String> of(String text) {
    return TOKENS.of(text);
  }

  @Test
  void wordsAreInSmallLettersWithoutWhatEndsASentence() {
    assertThat(of("Turn ON the light!")).containsExactly("turn", "on", "the", "light");
    assertThat(of("Really?! (Yes.)")).containsExactly("really", "yes");
  }

  @Test
  void aCommaIsAWordWithinASentence() {
    assertThat(of("uh, the lamp,please")).containsExactly("uh", ",", "the", "lamp,please");
    assertThat(of("lamp,, please")).containsExactly("lamp", ",", "please");
  }

  @Test
  void whatIsBrokenOffIsToldByADash() {
    assertThat(of("the bl- the lamp")).containsExactly("the", "bl", "-", "the", "lamp");
    assertThat(of("the blinds - no")).containsExactly("the", "blinds", "-", "no");
    assertThat(of("the blinds\u2014no")).containsExactly("the", "blinds", "-", "no");
    assertThat(of("the blinds--no")).containsExactly("the", "blinds", "-", "no");
    assertThat(of("the\u2026 lamp")).containsExactly("the", "-", "lamp");
    assertThat(of("the... lamp")).containsExactly("the", "-", "lamp");
  }

  @Test
  void aWordWithAHyphenIsOne() {
    assertThat(of("twenty-five")).containsExactly("twenty-five");
  }

  @Test
  void quotesAndBracketsAreNotPartOfWords() {
    assertThat(of("play \u201CBlue Train\u201D")).containsExactly("play", "blue", "train");
    assertThat(of("say \"hello\"")).containsExactly("say", "hello");
    assertThat(of("disc [unintelligible]")).containsExactly("disc", "unintelligible");
  }

  @Test
  void whoseSomethingIsStandsAlone() {
    assertThat(of("Tom's kids' room")).containsExactly("tom", "'s", "kids", "'s", "room");
    assertThat(of("Tom\u2019s room")).containsExactly("tom", "'s", "room");
    assertThat(of("Tom 's room")).containsExactly("tom", "'s", "room");
  }

  @Test
  void spellingsAreWrittenOutAlsoBehindFigures() {
    assertThat(of("Can't")).containsExactly("can", "not");
    assertThat(of("20%")).containsExactly("20", "percent");
    assertThat(of("21.5°C")).containsExactly("21.5", "degrees", "celsius");
    assertThat(of("7pm at 10:30")).containsExactly("7", "pm", "at", "10:30");
  }

  @Test
  void aBeginningStandsAloneAsAnEndingDoes() {
    Tokens french = new Tokens(Map.of("l'~", "l' ~", "~-tu", "~ tu"));
    assertThat(french.of("Peux-tu montrer l'heure"))
        .containsExactly("peux", "tu", "montrer", "l'", "heure");
    assertThat(french.of("l'")).containsExactly("l'");
  }

  @Test
  void writingFromTheRightIsWords() {
    assertThat(of("\u202Bהדלק את האור\u202C")).containsExactly("הדלק", "את", "האור");
    assertThat(of("turn on \u200Fأضئ\u200E now")).containsExactly("turn", "on", "أضئ", "now");
  }

  @Test
  void pictographsAreWords() {
    assertThat(of("turn on 💡!")).containsExactly("turn", "on", "💡");
  }

  @Test
  void signsThatControlPartWords() {
    assertThat(of("\u0000turn\u0007on\tthe\r\n\u001Blamp\uFEFF"))
        .containsExactly("turn", "on", "the", "lamp");
  }

  @Test
  void aTextWithoutWordsHasNone() {
    assertThat(of("")).isEmpty();
    assertThat(of("  \t\u0000 ")).isEmpty();
    assertThat(of("?! . \"\"")).isEmpty();
  }

  @Test
  void whatIsLongerThanAnyWordIsCutBetweenSigns() {
    assertThat(of("a".repeat(100_000))).containsExactly("a".repeat(64));
    assertThat(of("!".repeat(100_000) + "a")).isEmpty();
    assertThat(of("a" + "💡".repeat(100)).get(0)).isEqualTo("a" + "💡".repeat(31));
  }
}
