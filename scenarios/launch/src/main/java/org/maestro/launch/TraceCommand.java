package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Tells what was said for a goal in its story, between agents and on the bus. */
@Command(
    name = "trace",
    description = {
      "Tell what was said for a goal in its story, between agents and on the bus, in one line of time.",
      "A goal's id runs through all three; what is said again and again for one call is one line.",
    })
final class TraceCommand implements Callable<Integer> {
  private static final int TEXT_WIDTH = 100;

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(paramLabel = "GOAL", description = "A goal's id, such as G1.")
  private String goal;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    JsonNode document;
    try (AskedPlatform asked = platform.ask()) {
      document = asked.answer(questions -> questions.trace(goal));
    }
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(document);
      return ExitCode.DONE;
    }
    List<List<String>> rows = new ArrayList<>();
    document.path("trace").forEach(entry -> rows.add(row(entry)));
    new Table(List.of("Time", "Layer", "Kind", "From", "To", "What"), rows).print(out);
    long dropped = document.path("dropped").asLong();
    if (dropped > 0) {
      out.println("%d older entries are not kept any more.".formatted(dropped));
    }
    return ExitCode.DONE;
  }

  private static List<String> row(JsonNode entry) {
    int times = entry.path("times").asInt();
    String again =
        times == 1
            ? ""
            : " (%d times until %s)".formatted(times, seconds(entry.path("until_s").asDouble()));
    String call = entry.path("call").isNull() ? "" : " [" + entry.path("call").asText() + "]";
    return List.of(
        seconds(entry.path("at_s").asDouble()),
        entry.path("layer").asText(),
        entry.path("kind").asText(),
        Objects.requireNonNullElse(entry.path("from").textValue(), ""),
        Objects.requireNonNullElse(entry.path("to").textValue(), ""),
        cut(entry.path("text").asText()) + call + again);
  }

  private static String cut(String text) {
    return text.length() <= TEXT_WIDTH ? text : text.substring(0, TEXT_WIDTH - 1) + "…";
  }

  private static String seconds(double value) {
    return String.format(Locale.ROOT, "%.1f s", value);
  }
}
