package org.maestro.rats.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Half a character is found wherever it stands, and a whole one is never taken for it. */
class WholeTextTest {

  private static final String SMILE = "\ud83d\ude00";
  private static final String HIGH = "\ud83d";
  private static final String LOW = "\ude00";

  @Test
  void holdsWhatUtf8CanHold() {
    for (String whole : List.of("", "a", "\u00fc", SMILE, SMILE + SMILE, "a" + SMILE + "b")) {
      assertThat(WholeText.isWhole(whole)).as(whole).isTrue();
      assertThat(WholeText.mended(whole)).isEqualTo(whole);
    }
  }

  @Test
  void showsASignInPlaceOfEachHalf() {
    assertMended(HIGH, "\uFFFD");
    assertMended(LOW, "\uFFFD");
    assertMended("a" + HIGH, "a\uFFFD");
    assertMended(HIGH + "b", "\uFFFDb");
    assertMended("a" + LOW + "b", "a\uFFFDb");
    assertMended(LOW + HIGH, "\uFFFD\uFFFD");
    assertMended(HIGH + SMILE, "\uFFFD" + SMILE);
    assertMended(SMILE + LOW, SMILE + "\uFFFD");
    assertMended("a" + SMILE + HIGH + "b" + SMILE, "a" + SMILE + "\uFFFDb" + SMILE);
  }

  @Test
  void isCutOnlyWhenItIsLonger() {
    assertThat(WholeText.shortened("abc", 4)).isEqualTo("abc");
    assertThat(WholeText.shortened("abcd", 4)).isEqualTo("abcd");
    assertThat(WholeText.shortened("abcde", 4)).isEqualTo("abcd...");
  }

  @Test
  void isNotCutWithinACharacter() {
    assertThat(WholeText.shortened("abc" + SMILE, 4)).isEqualTo("abc...");
    assertThat(WholeText.shortened("ab" + SMILE + "c", 4)).isEqualTo("ab" + SMILE + "...");
    assertThat(WholeText.shortened("ab" + HIGH + "cd", 3)).isEqualTo("ab\uFFFD...");
  }

  @Property(tries = 500)
  void isWholeOnceMended(
      @ForAll("halvesAndWholes") String text, @ForAll @IntRange(min = 1, max = 12) int most) {
    assertThat(WholeText.isWhole(WholeText.mended(text))).isTrue();
    assertThat(WholeText.mended(text).length()).isEqualTo(text.length());
    assertThat(WholeText.isWhole(WholeText.shortened(text, most))).isTrue();
    assertThat(WholeText.shortened(text, most).length()).isLessThanOrEqualTo(most + 3);
  }

  @Provide
  Arbitrary<String> halvesAndWholes() {
    return Arbitraries.of("a", HIGH, LOW, SMILE)
        .list()
        .ofMaxSize(12)
        .map(parts -> String.join("", parts));
  }

  private static void assertMended(String broken, String mended) {
    assertThat(WholeText.isWhole(broken)).as(mended).isFalse();
    assertThat(WholeText.mended(broken)).isEqualTo(mended);
  }
}
