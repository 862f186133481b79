package org.maestro.launch;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.maestro.language.Language;
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
    lines(understood).forEach(out::println);
  }

  /** What became of it, a line each. */
  List<String> lines(Understanding understood) {
    List<String> lines = new ArrayList<>();
    understood.message().ifPresent(message -> lines.add("  means  " + SlPrinter.print(message)));
    understood.question().ifPresent(question -> lines.add("  asks   " + question));
    if (understood.message().isEmpty() && understood.question().isPresent()) {
      understood.meanings().stream()
          .map(Meaning::message)
          .flatMap(Optional::stream)
          .distinct()
          .limit(MOST_NAMED)
          .forEach(message -> lines.add("  may mean " + SlPrinter.print(message)));
    }
    understood.reply().ifPresent(reply -> lines.add("  says   " + reply));
    for (Heard word : understood.heard()) {
      if (word.fate() != Heard.Fate.TAKEN) {
        lines.add(
            "  %s is %s%s"
                .formatted(
                    word.word(),
                    word.fate().name().toLowerCase(Locale.ROOT),
                    word.as().map(other -> " (taken for " + other + ")").orElse("")));
      }
    }
    return lines;
  }

  /** A line for each word and reading: what may still fill its roles, and what is done then. */
  void narrowing(Language language, String utterance, Situation situation, PrintWriter out) {
    WordTable table = new WordTable(language, situation);
    List<List<String>> rows = new ArrayList<>();
    language.words(utterance).forEach(word -> rows.addAll(table.hear(word)));
    new Table(WordTable.COLUMNS, rows).print(out);
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
