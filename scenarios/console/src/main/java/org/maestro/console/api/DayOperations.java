package org.maestro.console.api;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import java.util.function.Supplier;
import org.maestro.console.access.Readership;
import org.maestro.console.api.Operation.Parameter;
import org.maestro.console.api.Operation.Request;
import org.maestro.console.documents.DayDocument;
import org.maestro.console.questions.RefusalException;
import org.maestro.dialogue.UtteranceCheck;
import org.maestro.diary.DayReport;
import org.maestro.diary.DaySentences;
import org.maestro.diary.Diary;
import org.maestro.language.Language;
import org.maestro.ontology.home.Home;

/** The operation that tells of a resident's day (ADE, 5; A70). */
public final class DayOperations {
  private final Diary diary;
  private final Supplier<Home> home;
  private final Readership readership;
  private final Function<Supplier<JsonNode>, CompletableFuture<JsonNode>> aside;

  /**
   * @param home as it is known at the time
   * @param readership who may read what is private
   * @param aside does work that takes a while beside those who wait for it
   */
  public DayOperations(
      Diary diary,
      Supplier<Home> home,
      Readership readership,
      Function<Supplier<JsonNode>, CompletableFuture<JsonNode>> aside) {
    this.diary = diary;
    this.home = home;
    this.readership = readership;
    this.aside = aside;
  }

  public Operation operation() {
    return Operation.get(
            "/days/{person}",
            "day",
            "A person's day: where she was, what devices were at, and what was asked for.",
            "day",
            request -> aside.apply(() -> document(request)))
        .with(
            Parameter.path("person", "By her name in the home, such as Bob."),
            Parameter.perhaps(
                "date", "By the home's clocks, such as 2026-01-31; without: the day that it is."));
  }

  private JsonNode document(Request request) {
    Home there = home.get();
    String person = request.parameter("person");
    new UtteranceCheck(there)
        .objection(person, Optional.empty())
        .ifPresent(
            objection -> {
              throw RefusalException.badInput(objection);
            });
    LocalDate date = request.perhaps("date").map(DayOperations::date).orElseGet(diary::today);
    DayReport report =
        diary
            .report(person, date, readership.of(request.visit()).hidden())
            .orElseThrow(
                () ->
                    RefusalException.badInput(
                        "Nothing is kept of %s; days of before are, for two months, where the platform runs with --data."
                            .formatted(date)));
    Language language = Language.of(there, Language.spoken(there, Optional.empty()));
    List<DaySentences.Told> told =
        new DaySentences(there, diary.zone(), language.grammar()).of(report);
    return DayDocument.of(report, diary.zone(), told);
  }

  private static LocalDate date(String text) {
    try {
      return LocalDate.parse(text);
    } catch (DateTimeException e) {
      throw RefusalException.badInput(
          "date is a day such as 2026-01-31, not \"%s\".".formatted(text));
    }
  }
}
