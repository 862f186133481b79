package org.maestro.coordination;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Says in plain words what was looked at in vain, and what could not be looked at and why. */
final class SearchSentences {
  private final ObstacleSentences obstacles;

  SearchSentences(ObstacleSentences obstacles) {
    this.obstacles = obstacles;
  }

  /** At most two: of what was looked at, and of what was not. */
  List<String> of(SearchReport report) {
    List<String> sentences = new ArrayList<>();
    if (!report.looks().isEmpty()) {
      sentences.add(
          report.looks().stream()
              .map(SearchSentences::look)
              .collect(
                  Collectors.joining("; ", report.thing() + " was looked for in vain: ", ".")));
    }
    if (!report.gaps().isEmpty()) {
      sentences.add(
          report.gaps().stream()
              .map(this::gap)
              .collect(Collectors.joining(" ", "Where " + report.thing() + " may still be: ", "")));
    }
    return sentences;
  }

  private static String look(SearchReport.Look look) {
    String covered =
        look.coveredShare().isPresent()
            ? " (%s %% of it in view)"
                .formatted(Sentences.number(100 * look.coveredShare().getAsDouble()))
            : "";
    return "in %s by %s at %s s%s"
        .formatted(look.place(), look.by(), Sentences.number(look.at().toMillis() / 1e3), covered);
  }

  private String gap(SearchReport.Gap gap) {
    return gap.place()
        + switch (gap.reason()) {
          case NOBODY_CAN -> ", into which nobody can look.";
          case MEMBERS_LOST, CONDITION ->
              gap.obstacles().stream()
                  .map(obstacles::obstacle)
                  .collect(Collectors.joining(" ", ", which was not looked at. ", ""));
          case LOOKED_IN_VAIN -> ", where looks settled nothing, and are not repeated for ever.";
          case OF_NO_USE -> ", where nobody looked, as that alone would not have helped.";
        };
  }
}
