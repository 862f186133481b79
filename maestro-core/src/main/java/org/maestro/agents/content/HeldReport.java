package org.maestro.agents.content;

import java.util.List;
import java.util.Locale;
import org.maestro.coordination.api.HeldNews;
import org.maestro.sl.Content;

/**
 * The report of how a held goal fares, as its requester is told: written by who holds it, read by
 * who stated it.
 *
 * @param goalId of the goal
 * @param isSo whether it is so from now on
 * @param confirmed whether that does not rest on the word of those alone who did it
 * @param reasons why it cannot be made so, in sentences; empty unless that is known
 */
public record HeldReport(String goalId, boolean isSo, boolean confirmed, List<String> reasons) {
  public HeldReport {
    reasons = List.copyOf(reasons);
  }

  /** The words in which it is told. */
  public static Content words(HeldNews news) {
    return Words.content(
        "inform",
        Words.named("goal", Words.name(news.goalId())),
        Words.named("state", Words.name(word(news.kind()))),
        Words.named("confirmed", Words.name(String.valueOf(news.confirmed()))),
        Words.named("reasons", news.reasons().stream().map(Words::text).toList()));
  }

  private static String word(HeldNews.Kind kind) {
    return kind.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Reads what {@link #words} wrote. */
  public static HeldReport read(boolean isSo, String content) {
    Words words = Words.of(Words.parse(content).get(0));
    return new HeldReport(
        words.string("goal").orElse(""),
        isSo,
        words.string("confirmed").filter("true"::equals).isPresent(),
        words.strings("reasons"));
  }
}
