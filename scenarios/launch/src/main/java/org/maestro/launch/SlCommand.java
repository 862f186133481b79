package org.maestro.launch;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.StatementCheck;
import org.maestro.ontology.home.WordList;
import org.maestro.sl.Formula;
import org.maestro.sl.Outline;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.text.VisibleText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Shows how lines of MAESTRO-SL are understood. */
@Command(
    name = "sl",
    description = "Read lines of MAESTRO-SL, and show how each is understood or what is wrong.",
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:all is right", "1:something is wrong", "2:bad input"})
final class SlCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(
      arity = "0..*",
      paramLabel = "LINE",
      description = "Such as \"(nextTo Cup Bob)\"; without: each line that is typed, or comes in.")
  private List<String> lines = List.of();

  @Option(
      names = "--home",
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      defaultValue = "bob",
      description =
          "Whose words are meant: a home file, or a shipped home; default ${DEFAULT-VALUE}.")
  private String home = "bob";

  /**
   * A reading of a line: as which kind, the parts and how its words are checked, or why it is none.
   */
  private record Reading(
      String kind,
      List<Outline.Line> parts,
      Function<StatementCheck, Optional<String>> words,
      Optional<SlSyntaxException> fault) {}

  @Override
  public Integer call() throws IOException {
    Home meant = Shipped.home(home);
    boolean allRight = true;
    if (!lines.isEmpty()) {
      for (String line : lines) {
        allRight &= show(line, meant);
      }
      return allRight ? ExitCode.DONE : ExitCode.NOT_REACHED;
    }
    BufferedReader typed =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = typed.readLine(); line != null; line = typed.readLine()) {
      if (!line.isBlank()) {
        allRight &= show(line, meant);
      }
    }
    return allRight ? ExitCode.DONE : ExitCode.NOT_REACHED;
  }

  private boolean show(String line, Home meant) {
    PrintWriter out = spec.commandLine().getOut();
    Reading reading = read(line, meant.vocabulary()::isFluent);
    if (reading.fault().isPresent()) {
      out.println(VisibleText.line(line.strip()));
      out.println(VisibleText.line(String.valueOf(reading.fault().get().getMessage())));
      out.println();
      out.flush();
      return false;
    }
    out.println(reading.kind());
    new Table(List.of("part", "role", "word"), rows(reading.parts(), meant)).print(out);
    Optional<String> fault = reading.words().apply(new StatementCheck(meant, "The line"));
    fault.ifPresent(sentence -> out.println(VisibleText.line(sentence)));
    out.println();
    out.flush();
    return fault.isEmpty();
  }

  private static List<List<String>> rows(List<Outline.Line> parts, Home meant) {
    List<WordList.Entry> words = WordList.of(meant);
    List<List<String>> rows = new ArrayList<>();
    for (Outline.Line part : parts) {
      String word =
          words.stream()
              .filter(entry -> entry.names(part.text()))
              .map(entry -> entry.kind() + " " + entry.form() + ": " + entry.meaning())
              .findFirst()
              .orElse("");
      rows.add(List.of("  ".repeat(part.depth()) + part.text(), part.role(), word));
    }
    return rows;
  }

  /** As the kind that fits; where none does, as the one that got furthest. */
  private static Reading read(String line, Predicate<String> fluents) {
    List<Reading> readings =
        List.of(
            as(
                "a goal or condition",
                () -> SlParser.formula(line, fluents),
                Outline::of,
                SlCommand::fault),
            as(
                "an effect",
                () -> SlParser.effect(line, fluents),
                Outline::of,
                (check, effect) -> check.fault(effect)),
            as(
                "a number",
                () -> SlParser.expression(line),
                Outline::of,
                (check, number) -> check.fault(number)));
    return readings.stream()
        .filter(reading -> reading.fault().isEmpty())
        .findFirst()
        .orElseGet(
            () ->
                readings.stream()
                    .max(Comparator.comparingInt(reading -> reading.fault().orElseThrow().column()))
                    .orElseThrow());
  }

  /** Of a goal that is bound, both the goal and what it is bound to. */
  private static Optional<String> fault(StatementCheck check, Formula formula) {
    return formula instanceof Formula.Bound
        ? formula.parts().stream().flatMap(part -> fault(check, part).stream()).findFirst()
        : check.fault(formula);
  }

  private static <T> Reading as(
      String kind,
      Supplier<T> reader,
      Function<T, List<Outline.Line>> outline,
      BiFunction<StatementCheck, T, Optional<String>> words) {
    try {
      T read = reader.get();
      return new Reading(
          kind, outline.apply(read), check -> words.apply(check, read), Optional.empty());
    } catch (SlSyntaxException e) {
      return new Reading("", List.of(), check -> Optional.empty(), Optional.of(e));
    }
  }
}
