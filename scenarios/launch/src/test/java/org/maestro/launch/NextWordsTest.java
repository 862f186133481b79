package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.language.Language;
import org.maestro.language.reference.Situation;

/** Words with which what somebody writes could go on. */
class NextWordsTest {
  private static final int ALL = 100_000;

  private final SpokenEvening evening = new SpokenEvening();
  private final Language language = Language.of(evening.home(), "en");
  private final SpokenEvening.Line dave = SpokenEvening.lines().get(0);

  private List<String> next(String text, int most) {
    return language.next(text, evening.situation(evening.home(), dave), most);
  }

  @Test
  void theyBeginAsWhatIsBeingWrittenDoesAndGoOnAsNamesDo() {
    assertThat(next("turn on the kitch", 10)).containsExactly("kitchen");
    assertThat(next("Turn on the floor l", 10)).contains("lamp");
    assertThat(next("tu", 10)).contains("turn");
    assertThat(next("turn on the ", 7)).hasSize(7).isSorted();
  }

  @Test
  void thereAreNoneAfterWhatFitsNothing() {
    assertThat(next("blorp the ", ALL)).isEmpty();
    assertThat(next("turn on the xyz", ALL)).isEmpty();
    assertThat(next("turn on blorp the ", ALL)).isEmpty();
    assertThat(next("", ALL)).contains("turn", "put").allMatch(word -> !word.isBlank());
  }

  /** What is left out are parts of words, and classes of which there is nothing. */
  @Test
  void nearlyEveryWordThatIsUnderstoodIsAmongThem() {
    List<String> missed = new ArrayList<>();
    int all = 0;
    for (SpokenEvening.Line line : SpokenEvening.lines()) {
      Situation situation = evening.situation(evening.home(), line);
      List<String> words = language.words(line.words());
      boolean isPlain =
          SpokenEvening.understood(language, words, situation).heard().stream()
              .allMatch(heard -> heard.fate().name().equals("TAKEN"));
      for (int i = 0; isPlain && i < words.size(); i++) {
        String before = String.join(" ", words.subList(0, i)) + " ";
        all++;
        if (!language.next(before, situation, ALL).contains(words.get(i))) {
          missed.add(before + "|" + words.get(i));
        }
      }
    }
    assertThat(all).isGreaterThan(400);
    assertThat(missed).as("of %d: %s", all, missed).hasSizeLessThan(all / 20);
  }
}
