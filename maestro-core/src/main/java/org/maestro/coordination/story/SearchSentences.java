package org.maestro.coordination.story;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.maestro.coordination.api.SearchReport;
import org.maestro.coordination.api.Sentences;

/** Says in plain words what was looked at in vain, and what could not be looked at and why. */
public final class SearchSentences {
  private final ObstacleSentences obstacles;
  private final Duration now;

  /**
   * @param now simulated time since the platform's start: looks are told by their age, since those
   *     who read the story count its time from elsewhere
   */
  public SearchSentences(ObstacleSentences obstacles, Duration now) {
    this.obstacles = obstacles;
    this.now = now;
  }

  /** At most two: of what was looked at, and of what was not. */
  public List<String> of(SearchReport report) {
    List<String> sentences = new ArrayList<>();
    if (!report.looks().isEmpty()) {
      sentences.add(
          report.looks().stream()
              .map(this::look)
              .collect(
                  Collectors.joining("; ", report.thing() + " was looked for in vain: ", ".")));
    }
    if (!report.gaps().isEmpty()) {
      sentences.add("Where " + report.thing() + " may still be: " + gaps(report.gaps()));
    }
    return sentences;
  }

  private String look(SearchReport.Look look) {
    String covered =
        look.coveredShare().isPresent()
            ? " (%s %% of it in view)"
                .formatted(Sentences.number(100 * look.coveredShare().getAsDouble()))
            : "";
    return "in %s by %s %s s ago%s"
        .formatted(
            look.place(),
            look.by(),
            Sentences.number(now.minus(look.at()).toMillis() / 1e3),
            covered);
  }

  /** Places that nobody looked at for the same reason are told together. */
  private String gaps(List<SearchReport.Gap> gaps) {
    Map<String, List<SearchReport.Gap>> alike = new LinkedHashMap<>();
    for (SearchReport.Gap gap : gaps) {
      alike.computeIfAbsent(gap.reason() + why(gap), same -> new ArrayList<>()).add(gap);
    }
    return alike.values().stream().map(this::together).collect(Collectors.joining(" "));
  }

  private String together(List<SearchReport.Gap> alike) {
    SearchReport.Gap first = alike.get(0);
    return alike.stream().map(SearchReport.Gap::place).collect(Collectors.joining(", "))
        + switch (first.reason()) {
          case NOBODY_CAN -> ", into which nobody can look.";
          case MEMBERS_LOST, CONDITION ->
              ", which %s not looked at. %s"
                  .formatted(alike.size() == 1 ? "was" : "were", why(first));
          case LOOKED_IN_VAIN -> ", where looks settled nothing, and are not repeated for ever.";
          case OF_NO_USE -> ", where nobody looked, as that alone would not have helped.";
          case NOT_DECIDED ->
              ", where nobody looked; whether anybody could was too much to be planned.";
        };
  }

  private String why(SearchReport.Gap gap) {
    return gap.obstacles().stream().map(obstacles::obstacle).collect(Collectors.joining(" "));
  }
}
