package org.maestro.launch;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.language.Language;
import org.maestro.language.Listening;
import org.maestro.language.Understanding;
import org.maestro.language.hearing.Heard;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.Situation;
import org.maestro.sl.SlPrinter;

/** What was understood, as text and as JSON. */
final class UnderstoodText {
  private static final int MOST_NAMED = 6;
  private static final ObjectMapper JSON = new ObjectMapper();

  void print(Understanding understood, PrintWriter out) {
    out.println(understood.utterance());
    understood.message().ifPresent(message -> out.println("  means  " + SlPrinter.print(message)));
    understood.question().ifPresent(question -> out.println("  asks   " + question));
    if (understood.message().isEmpty() && understood.question().isPresent()) {
      understood.meanings().stream()
          .map(Meaning::message)
          .flatMap(Optional::stream)
          .distinct()
          .limit(MOST_NAMED)
          .forEach(message -> out.println("  may mean " + SlPrinter.print(message)));
    }
    understood.reply().ifPresent(reply -> out.println("  says   " + reply));
    for (Heard word : understood.heard()) {
      if (word.fate() != Heard.Fate.TAKEN) {
        out.printf(
            "  %s is %s%s%n",
            word.word(),
            word.fate().name().toLowerCase(Locale.ROOT),
            word.as().map(other -> " (taken for " + other + ")").orElse(""));
      }
    }
  }

  /** A line for each word and reading: what may still fill its roles. */
  void narrowing(Language language, String utterance, Situation situation, PrintWriter out) {
    Listening listening = language.listen(situation);
    List<List<String>> rows = new ArrayList<>();
    for (String word : language.words(utterance)) {
      listening.hear(word);
      String shown = word;
      for (Understanding.UnderWay reading : listening.underWay()) {
        rows.add(List.of(shown, reading.construction(), roles(reading)));
        shown = "";
      }
      if (!shown.isEmpty()) {
        rows.add(List.of(shown, "", ""));
      }
    }
    new Table(List.of("word", "reading", "may be"), rows).print(out);
  }

  private static String roles(Understanding.UnderWay reading) {
    return reading.roles().entrySet().stream()
        .filter(role -> !role.getValue().isEmpty())
        .map(
            role ->
                role.getValue().size() > MOST_NAMED
                    ? role.getKey() + ": " + role.getValue().size()
                    : role.getKey() + ": " + String.join(", ", role.getValue()))
        .collect(Collectors.joining("; "));
  }

  ObjectNode document(Understanding understood) {
    ObjectNode document = JSON.createObjectNode();
    document.put("utterance", understood.utterance());
    put(document, "meaning", understood.message().map(SlPrinter::print));
    put(document, "question", understood.question());
    put(document, "reply", understood.reply());
    ArrayNode began = document.putArray("began");
    understood
        .began()
        .forEach(
            begun -> {
              ObjectNode one = began.addObject();
              one.put("after", begun.after());
              one.put("message", SlPrinter.print(begun.message()));
              put(one, "calledOff", begun.calledOff());
            });
    ArrayNode unknown = document.putArray("unknown");
    understood.unknown().forEach(unknown::add);
    document.put("coverage", Math.round(understood.coverage() * 100) / 100.0);
    document.put("readings", understood.meanings().size());
    put(document, "kind", understood.meanings().stream().findFirst().map(Meaning::kind));
    return document;
  }

  private static void put(ObjectNode document, String name, Optional<String> value) {
    if (value.isPresent()) {
      document.put(name, value.get());
    } else {
      document.putNull(name);
    }
  }
}
