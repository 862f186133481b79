package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Optional;
import org.maestro.diary.DayReport;
import org.maestro.diary.DaySentences;

/** A person's day, as data and in sentences (ADE, 5; A70). */
public final class DayDocument {
  private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss");

  private final DayReport report;
  private final ZoneId zone;

  private DayDocument(DayReport report, ZoneId zone) {
    this.report = report;
    this.zone = zone;
  }

  /**
   * @param zone of the home's clocks
   * @param told the report in sentences
   */
  public static JsonNode of(DayReport report, ZoneId zone, List<DaySentences.Told> told) {
    return new DayDocument(report, zone).document(told);
  }

  private JsonNode document(List<DaySentences.Told> told) {
    JsonMembers document =
        JsonMembers.empty()
            .text("person", report.person())
            .text("date", report.date().toString())
            .text("until", time(report.until()));
    ArrayNode sentences = document.node().putArray("told");
    for (DaySentences.Told sentence : told) {
      JsonMembers.in(sentences)
          .text("from", CLOCK.format(sentence.from()))
          .text("to", sentence.to().map(CLOCK::format))
          .text("text", ShownText.of(sentence.text()));
    }
    ArrayNode stays = document.node().putArray("stays");
    for (DayReport.Stay stay : report.stays()) {
      JsonMembers.in(stays)
          .text("zone", stay.zone())
          .text("from", time(stay.from()))
          .text("to", time(stay.to()));
    }
    ArrayNode silences = document.node().putArray("silences");
    for (DayReport.Silence silence : report.silences()) {
      JsonMembers.in(silences).text("from", time(silence.from())).text("to", time(silence.to()));
    }
    ArrayNode changes = document.node().putArray("changes");
    for (DayReport.Change change : report.changes()) {
      JsonMembers.in(changes).text("at", time(change.at())).text("fact", change.fact());
    }
    ArrayNode requests = document.node().putArray("requests");
    report.requests().forEach(request -> add(JsonMembers.in(requests), request));
    document.node().put("left_out", report.leftOut());
    return document.node();
  }

  private void add(JsonMembers row, DayReport.Request request) {
    Optional<DayReport.End> end = request.end();
    row.text("at", time(request.at()))
        .text("id", request.id())
        .text("goal", ShownText.of(request.goal()))
        .text("by", ShownText.of(request.by()))
        .text("person", request.person())
        .text("ended", end.map(it -> time(it.at())))
        .text("end", end.map(DayReport.End::how))
        .text("reason", end.map(it -> ShownText.of(it.reason())));
  }

  private String time(Instant at) {
    return at.atZone(zone).toOffsetDateTime().toString();
  }
}
