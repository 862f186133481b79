package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.bench.Quantile;
import org.maestro.language.Language;
import org.maestro.language.Understanding;
import org.maestro.language.hearing.Heard;
import org.maestro.language.hearing.HeardWords;
import org.maestro.language.lexicon.Tokens;
import org.maestro.sl.SlPrinter;

/** Whatever is said, something is answered, and no word that is not known is passed over. */
class RandomWordsTest {
  private static final long SEED = 20260;
  private static final int UTTERANCES = 4_000;
  private static final int MANY = 100_000;
  private static final double NANOS_PER_MILLI = 1e6;

  /** Of a core; all words of an utterance may come to their ends with its last one. */
  private static final double SLOWEST_MILLIS = 1_000;

  private static final double MEAN_MILLIS = 5;
  private static final Pattern TEXT = Pattern.compile("\"([^\"]*)\"");
  private static final List<String> ODD =
      List.of(
          "💡",
          "👩\u200D👧",
          "\u202Eהדלק\u202C",
          "\u200Fأضئ",
          "li\u200Bght",
          "\u200B",
          "\uFEFFturn",
          "\u0301",
          "\u2066on\u2069",
          "\u0007\u0008",
          "\r\n",
          "\t",
          "\u0000",
          "\u001B[31m",
          "x".repeat(5_000),
          "💡".repeat(200),
          "'s",
          "%",
          "-",
          ",",
          "\"",
          "(:goal",
          "\uD83D",
          "\\",
          "12:99",
          "999999999999",
          "-5",
          "zzyzx",
          "frobnicated",
          "quuxes");

  private final SpokenEvening evening = new SpokenEvening();
  private final Language language = Language.of(evening.home(), "en");
  private final Set<String> known = known();
  private final Random random = new Random(SEED);

  private Set<String> known() {
    Set<String> words = new HashSet<>(language.lexicon().words());
    words.addAll(HeardWords.wordsOf(language.grammar()));
    language.grammar().lists().values().forEach(list -> list.forEach(words::addAll));
    words.add(Tokens.CUT_OFF);
    return words;
  }

  @Test
  void whateverIsSaidNoUnknownWordIsPassedOver() {
    said(UTTERANCES);
  }

  @Test
  @Tag("full")
  void howeverMuchIsSaidNoUnknownWordIsPassedOver(TestReporter reporter) {
    List<Double> millis = said(MANY);

    double mean = millis.stream().mapToDouble(each -> each).average().orElseThrow();
    double slowest = Quantile.of(millis, 1);
    reporter.publishEntry(
        String.format(
            Locale.ROOT,
            "%d utterances, ms of a core a word: mean %.2f, 99 of 100 %.2f, the slowest %.1f",
            MANY,
            mean,
            Quantile.of(millis, 0.99),
            slowest));
    assertThat(mean).isLessThan(MEAN_MILLIS);
    assertThat(slowest).isLessThan(SLOWEST_MILLIS);
  }

  /**
   * Says utterances at random, each mutated or of words at random; returns for each what one word
   * of it took of a core, in ms.
   */
  private List<Double> said(int utterances) {
    List<SpokenEvening.Line> lines = SpokenEvening.lines();
    List<String> vocabulary = new ArrayList<>(new TreeSet<>(known));
    List<Double> millis = new ArrayList<>();
    int understood = 0;
    for (int i = 0; i < utterances; i++) {
      SpokenEvening.Line line = lines.get(random.nextInt(lines.size()));
      String text =
          String.join(
              " ", random.nextInt(8) == 0 ? anyWords(vocabulary) : mutated(line, vocabulary));
      long begun = coreNanos();
      Understanding understanding =
          language.understand(text, evening.situation(evening.home(), line));
      millis.add(
          (coreNanos() - begun) / NANOS_PER_MILLI / Math.max(1, understanding.heard().size()));
      assertThat(passedOver(understanding)).as("%s", understanding).isEmpty();
      assertThat(isAnswered(understanding)).as("%s", understanding).isTrue();
      understood += understanding.message().isPresent() ? 1 : 0;
    }

    // So that not all of it was nonsense.
    assertThat(understood).isBetween(utterances / 10, utterances * 9 / 10);
    return millis;
  }

  private static long coreNanos() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  private List<String> mutated(SpokenEvening.Line line, List<String> vocabulary) {
    List<String> words = new ArrayList<>(List.of(line.words().split(" ")));
    int changes = random.nextInt(4);
    for (int change = 0; change < changes; change++) {
      change(words, vocabulary);
    }
    return words;
  }

  private List<String> anyWords(List<String> vocabulary) {
    return Stream.generate(() -> any(random.nextInt(6) == 0 ? ODD : vocabulary))
        .limit(1 + random.nextInt(12))
        .toList();
  }

  private void change(List<String> words, List<String> vocabulary) {
    int at = random.nextInt(words.size() + 1);
    int other = random.nextInt(words.size() + 1);
    boolean isThere = at < words.size() && other < words.size();
    switch (random.nextInt(7)) {
      case 0 -> {
        if (isThere) {
          String moved = words.set(at, words.get(other));
          words.set(other, moved);
        }
      }
      case 1 -> {
        if (isThere && words.size() > 1) {
          words.remove(at);
        }
      }
      case 2 -> {
        if (isThere) {
          words.add(at, words.get(at));
        }
      }
      case 3 -> {
        if (isThere) {
          words.set(at, any(vocabulary));
        }
      }
      case 4 -> words.add(at, any(vocabulary));
      case 5 -> words.add(at, any(ODD));
      default -> {
        if (isThere) {
          words.set(at, slip(words.get(at)));
        }
      }
    }
  }

  private String any(List<String> words) {
    return words.get(random.nextInt(words.size()));
  }

  /** One letter is another. */
  private String slip(String word) {
    int at = random.nextInt(word.length());
    return word.substring(0, at) + (char) ('a' + random.nextInt(26)) + word.substring(at + 1);
  }

  /** Something is done, asked or said, or what was said answers nothing that was asked. */
  private static boolean isAnswered(Understanding understanding) {
    return understanding.heard().isEmpty()
        || !understanding.meanings().isEmpty()
        || understanding.message().isPresent()
        || understanding.question().isPresent()
        || understanding.reply().isPresent();
  }

  /**
   * Unknown words of what was understood all the same: neither taken for another one, nor taken
   * back, nor part of a text.
   */
  private List<String> passedOver(Understanding understanding) {
    if (understanding.message().isEmpty()) {
      return List.of();
    }
    List<Heard> heard = understanding.heard();
    int lastRepair = 0;
    for (int i = 0; i < heard.size(); i++) {
      lastRepair = heard.get(i).fate() == Heard.Fate.REPAIR ? i : lastRepair;
    }
    String message = SlPrinter.print(understanding.message().orElseThrow());
    String texts =
        TEXT.matcher(message).results().map(MatchResult::group).collect(Collectors.joining(" "));
    return heard.subList(lastRepair, heard.size()).stream()
        .filter(word -> word.fate() != Heard.Fate.MISHEARD)
        .map(Heard::word)
        .filter(word -> !known.contains(word) && !language.lexicon().knows(word))
        .filter(word -> !texts.contains(word))
        .toList();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "the ",
        "turn on the reading lamp and ",
        "zzyzx ",
        "no ",
        "uh ",
        "- ",
        "turn ",
        "the lamp in the kitchen of ",
        "two hundred ",
      })
  void aVeryLongSentenceIsAnswered(String repeated) {
    int words = 10_000;
    String text = repeated.repeat(words / repeated.split(" ").length);

    assertThat(isAnswered(said(text))).isTrue();
  }

  @Test
  void aVeryLongTextIsAnswered() {
    assertThat(isAnswered(said("tell Rose that " + "zzyzx ".repeat(10_000)))).isTrue();
  }

  private Understanding said(String text) {
    return language.understand(
        text, evening.situation(evening.home(), SpokenEvening.lines().get(0)));
  }
}
