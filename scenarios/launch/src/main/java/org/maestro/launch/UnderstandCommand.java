package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.jline.terminal.Attributes;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;
import org.maestro.language.Language;
import org.maestro.language.Understanding;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Shows what is understood of an utterance, without a platform. */
@Command(
    name = "understand",
    description = "Show what is understood of words: the message that they mean, or what is asked.")
final class UnderstandCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(arity = "0..1", paramLabel = "WORDS", description = "What is said, in quotes.")
  private Optional<String> words = Optional.empty();

  @Option(
      names = "--home",
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      defaultValue = "evening",
      description = "A home file, or a shipped home; ${DEFAULT-VALUE} unless stated.")
  private String home;

  @Option(
      names = "--scene",
      paramLabel = "SCENE.ttl",
      description = "What is so in the home: a scene file, or a shipped scene.")
  private Optional<String> scene = Optional.empty();

  @Option(names = "--as", paramLabel = "PERSON", description = "Who speaks.")
  private Optional<String> speaker = Optional.empty();

  @Option(names = "--in", paramLabel = "ROOM", description = "Where it is said.")
  private Optional<String> room = Optional.empty();

  @Option(names = "--to", paramLabel = "ROBOT", description = "The robot to which it is said.")
  private Optional<String> robot = Optional.empty();

  @Option(
      names = "--at",
      paramLabel = "HH:MM",
      description = "What the clock shows; 18:05 unless stated.",
      defaultValue = "18:05")
  private String time;

  @Mixin private SpokenLanguage spoken;

  @Option(
      names = "--file",
      paramLabel = "FILE.tsv",
      description =
          "Utterances, one a line, and if wished, after tabulators, who speaks, in which room, and"
              + " what was said before.")
  private Optional<Path> file = Optional.empty();

  @Option(names = "--words", description = "Show after each word what could still be meant.")
  private boolean wordByWord;

  @Option(
      names = "--type",
      description = "Show it word by word as it is typed here; Ctrl-D ends it.")
  private boolean typed;

  @Option(
      names = "--unused",
      description = "Show at the end which rules of the grammar none of the utterances uses.")
  private boolean unused;

  @Option(names = "--json", description = "Print one JSON document a line.")
  private boolean json;

  @Override
  public Integer call() {
    if (unused && json) {
      throw CommandException.badInput("--unused prints no JSON; leave --json away.");
    }
    if (typed && (json || unused || wordByWord)) {
      throw CommandException.badInput(
          "--type shows words as they are typed; leave --words, --json and --unused away.");
    }
    if (Stream.of(words.isPresent(), file.isPresent(), typed).filter(given -> given).count() != 1) {
      throw CommandException.badInput("Give words in quotes, or --file, or --type, one of them.");
    }
    Home there = Shipped.home(home);
    Facts facts = SceneFacts.of(there, scene.map(name -> Shipped.scene(name, there)));
    UnderstoodText text = new UnderstoodText();
    UsedRules rules = new UsedRules();
    PrintWriter out = spec.commandLine().getOut();
    if (typed) {
      type(there, facts, out);
      return ExitCode.DONE;
    }
    List<String> lines =
        file.map(UnderstandCommand::lines).orElseGet(() -> List.of(words.orElseThrow()));
    for (String line : lines) {
      String[] columns = line.split("\t", -1);
      Optional<String> said =
          column(columns, 1).or(() -> speaker).map(name -> individual(there, name));
      Language language = spoken.of(there, said);
      Situation situation = situation(there, facts, said, column(columns, 2).or(() -> room));
      Optional<String> before = column(columns, 3);
      if (before.isPresent()) {
        situation =
            situation.after(
                language.understand(before.get(), situation).discourse(situation.discourse()));
      }
      long begun = System.nanoTime();
      Understanding understood = language.understand(columns[0], situation);
      double microseconds =
          (System.nanoTime() - begun) / 1e3 / Math.max(1, understood.heard().size());
      if (unused) {
        rules.note(language, columns[0], situation);
      }
      Optional<String> refusal = language.refusal(understood, situation);
      if (wordByWord) {
        text.narrowing(language, columns[0], situation, out);
      }
      if (json) {
        ObjectNode document = text.document(understood);
        document.put("refusal", refusal.orElse(null));
        document.put("microseconds", Math.round(microseconds * 10) / 10.0);
        out.println(document);
      } else {
        text.print(understood, out);
        refusal.ifPresent(sentence -> out.println("  tells  " + sentence));
      }
    }
    rules.print(out);
    return ExitCode.DONE;
  }

  private Situation situation(
      Home there, Facts facts, Optional<String> said, Optional<String> where) {
    return new Situation(
        there,
        facts,
        said,
        where.map(name -> individual(there, name)),
        robot.map(name -> individual(there, name)),
        minuteOfDay(),
        Discourse.NONE);
  }

  /** Keys come one by one from a terminal, and as they are from a pipe. */
  private void type(Home there, Facts facts, PrintWriter out) {
    Optional<String> said = speaker.map(name -> individual(there, name));
    Language language = spoken.of(there, said);
    Situation situation = situation(there, facts, said, room);
    try {
      if (Optional.ofNullable(System.console()).isEmpty()) {
        Reader keys = new InputStreamReader(System.in, StandardCharsets.UTF_8);
        new TypedWords(keys, out, false, language, situation).understand();
        return;
      }
      try (Terminal terminal = TerminalBuilder.builder().dumb(true).build()) {
        Attributes usual = terminal.enterRawMode();
        try {
          new TypedWords(terminal.reader(), terminal.writer(), true, language, situation)
              .understand();
        } finally {
          terminal.setAttributes(usual);
        }
      }
    } catch (IOException e) {
      throw CommandException.badInput(
          "What is typed cannot be read any more: %s.".formatted(e.getMessage()));
    }
  }

  private static Optional<String> column(String[] columns, int index) {
    return index < columns.length && !columns[index].isBlank()
        ? Optional.of(columns[index].strip())
        : Optional.empty();
  }

  private static String individual(Home home, String name) {
    if (!home.individuals().containsKey(name)) {
      throw CommandException.badInput(
          "The home has no %s; ./maestro words lists what it has.".formatted(name));
    }
    return name;
  }

  private OptionalInt minuteOfDay() {
    String[] parts = time.split(":");
    try {
      return OptionalInt.of(Integer.parseInt(parts[0]) * 60 + Integer.parseInt(parts[1]));
    } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
      throw CommandException.badInput(
          "--at %s is no time; write one such as 18:05.".formatted(time));
    }
  }

  /** The lines of a list of utterances. */
  static List<String> lines(Path file) {
    try {
      return Files.readAllLines(file).stream()
          .filter(line -> !line.isBlank() && !line.startsWith("#"))
          .toList();
    } catch (IOException e) {
      throw CommandException.badInput(
          "The file %s cannot be read; give one in UTF-8.".formatted(file));
    }
  }
}
