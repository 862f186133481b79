package org.maestro.launch;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.Optional;
import org.maestro.language.Understanding;
import org.maestro.language.hearing.Heard;
import org.maestro.language.meaning.Meaning;
import org.maestro.sl.SlPrinter;

/** What was understood, as text and as JSON. */
final class UnderstoodText {
  private static final ObjectMapper JSON = new ObjectMapper();

  void print(Understanding understood, PrintWriter out) {
    out.println(understood.utterance());
    understood.message().ifPresent(message -> out.println("  means  " + SlPrinter.print(message)));
    understood.question().ifPresent(question -> out.println("  asks   " + question));
    understood.reply().ifPresent(reply -> out.println("  says   " + reply));
    for (Heard word : understood.heard()) {
      if (word.fate() != Heard.Fate.TAKEN) {
        out.printf(
            "  %s is %s%s%n",
            word.word(),
            word.fate().name().toLowerCase(java.util.Locale.ROOT),
            word.as().map(other -> " (taken for " + other + ")").orElse(""));
      }
    }
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
