package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.maestro.language.Language;
import org.maestro.language.wording.AnswerWords;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Truth;

/** Answers name things as people do, and tell when they are old; what is not known is not no. */
class AnswerWordsTest {
  private final Home home = Shipped.home("evening");
  private final AnswerWords words = new AnswerWords(home, Language.of(home, "en").grammar());

  private static AnswerWords.Found found(Truth truth, Map<String, String> binding, double age) {
    return new AnswerWords.Found(truth, binding, OptionalDouble.of(age));
  }

  @Test
  void whatWasAskedForIsNamed() {
    assertThat(words.of(List.of(found(Truth.TRUE, Map.of("where", "kidsroom"), 1))))
        .isEqualTo("The kids' room.");
    Map<String, String> tom = new LinkedHashMap<>(Map.of("x", "Tom"));
    tom.put("where", "kidsroom");
    Map<String, String> mia = new LinkedHashMap<>(Map.of("x", "Mia"));
    mia.put("where", "bathroom");
    assertThat(words.of(List.of(found(Truth.TRUE, tom, 10), found(Truth.TRUE, mia, 10))))
        .isEqualTo("Tom: the kids' room and Mia: the bathroom.");
    assertThat(words.of(List.of(found(Truth.TRUE, Map.of("value", "20.456"), 1))))
        .isEqualTo("20.46.");
  }

  /** A thermometer is right to half a degree, and nobody asks how many thousandths a lamp has. */
  @Test
  void aNumberIsToldAsFinelyAsTheHomeSays() {
    assertThat(told("temperature", 19.02)).isEqualTo("19 °C.");
    assertThat(told("temperature", 20.77)).isEqualTo("21 °C.");
    assertThat(told("temperature", -0.31)).isEqualTo("-0.5 °C.");
    assertThat(told("temperature", -0.1)).isEqualTo("0 °C.");
    assertThat(told("illuminance", 153.27)).isEqualTo("153 lux.");
    assertThat(told("level", 0.3333)).isEqualTo("33 percent.");
    assertThat(told("mass", 0.25)).isEqualTo("0.25 kg.");
    assertThat(
            new AnswerWords(home, Language.of(home, "de").grammar())
                .of(number(21.3), Optional.of("temperature")))
        .isEqualTo("21,5 °C.");
  }

  private String told(String fluent, double number) {
    return words.of(number(number), Optional.of(fluent));
  }

  private static List<AnswerWords.Found> number(double value) {
    return List.of(found(Truth.TRUE, Map.of("value", String.valueOf(value)), 1));
  }

  private static AnswerWords.Found likely(Map<String, String> binding) {
    return new AnswerWords.Found(Truth.TRUE, binding, OptionalDouble.of(1), 0.8);
  }

  @Test
  void whatIsOnlyLikelyIsToldAsThat() {
    assertThat(words.of(List.of(likely(Map.of("where", "kitchen")))))
        .isEqualTo("Probably the kitchen.");
    assertThat(words.of(List.of(likely(Map.of())))).isEqualTo("Probably.");
    Map<String, String> mia = new LinkedHashMap<>(Map.of("x", "Mia"));
    mia.put("where", "bathroom");
    assertThat(words.of(List.of(likely(mia)))).isEqualTo("Mia: probably the bathroom.");
    assertThat(
            new AnswerWords(home, Language.of(home, "de").grammar()).of(List.of(likely(Map.of()))))
        .isEqualTo("Wahrscheinlich ja.");
  }

  @Test
  void unknownIsNotNo() {
    assertThat(words.of(List.of(found(Truth.TRUE, Map.of(), 1)))).isEqualTo("Yes.");
    assertThat(words.of(List.of(found(Truth.FALSE, Map.of(), 1)))).isEqualTo("No.");
    assertThat(words.of(List.of(found(Truth.UNKNOWN, Map.of(), 1)))).isEqualTo("I do not know.");
    assertThat(words.of(List.of())).isEqualTo("I do not know.");
  }

  @Test
  void whatIsOldIsSaidToBe() {
    assertThat(words.of(List.of(found(Truth.TRUE, Map.of(), 600))))
        .isEqualTo("Yes. That was ten minutes ago.");
    assertThat(words.of(List.of(found(Truth.FALSE, Map.of(), 3700))))
        .isEqualTo("No. That was an hour ago.");
  }

  @Test
  void howManyThereAreIsSaidInWords() {
    List<AnswerWords.Found> apples =
        List.of(
            found(Truth.TRUE, Map.of("x", "apple-1"), 1),
            found(Truth.TRUE, Map.of("x", "apple-2"), 1));
    assertThat(words.counted(apples, true)).isEqualTo("Two.");
    assertThat(words.counted(apples, false)).isEqualTo("Two that I know of.");
    assertThat(words.counted(List.of(found(Truth.FALSE, Map.of(), 1)), true)).isEqualTo("Zero.");
  }
}
