package org.maestro.platform;

import java.util.List;
import org.maestro.agents.content.Words;

/**
 * How a held goal fares, as its requester is told.
 *
 * @param isSo whether it is so from now on
 * @param confirmed whether that does not rest on the word of those alone who did it
 * @param reasons why it cannot be made so, in sentences; empty unless that is known
 */
public record HeldReport(boolean isSo, boolean confirmed, List<String> reasons) {
  public HeldReport {
    reasons = List.copyOf(reasons);
  }

  static HeldReport read(boolean isSo, String content) {
    Words words = Words.of(Words.parse(content).get(0));
    return new HeldReport(
        isSo,
        words.string("confirmed").filter("true"::equals).isPresent(),
        words.find("reasons").map(Words::terms).orElse(List.of()).stream()
            .map(Words::plain)
            .toList());
  }
}
