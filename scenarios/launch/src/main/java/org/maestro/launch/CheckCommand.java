package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ArrayNode;
import jade.lang.acl.ACLMessage;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.VerdictWords;
import org.maestro.agents.content.Words;
import org.maestro.ontology.home.DescriptionCheck;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeFaultException;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.ImpossibleUses;
import org.maestro.ontology.home.UnstatedNeeds;
import org.maestro.ontology.validation.Fault;
import org.maestro.platform.JoinedContainer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Reads a home file, or what a device says of itself, and tells the faults. */
@Command(
    name = "check",
    description =
        "Tell every fault of a home file, or of a device's description, with its place and cure.")
final class CheckCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private PlatformOptions platform;

  @Parameters(
      paramLabel = "FILE",
      description =
          "A home file, or a shipped home: bob, arena; or a description in JSON-LD, FILE.json or"
              + " FILE.jsonld, as a device sends it.")
  private String file;

  @Option(
      names = "--home",
      paramLabel = "HOME.ttl",
      description = "The home that the described device is to join; without: one without words.")
  private Optional<String> home = Optional.empty();

  @Option(
      names = "--running",
      description = "Ask the running platform whether the described device could join it now.")
  private boolean running;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    if (file.endsWith(".json") || file.endsWith(".jsonld")) {
      return checkDescription();
    }
    if (home.isPresent() || running) {
      throw CommandException.badInput(
          "--home and --running go with a description, a file whose name ends with .json or"
              + " .jsonld.");
    }
    return checkHome();
  }

  private int checkDescription() {
    if (home.isPresent() && running) {
      throw CommandException.badInput("--home and --running exclude each other; leave one away.");
    }
    String text = Shipped.read(Shipped.file(file, "description", List.of()));
    List<Words> verdict = running ? asked(text) : found(text);
    List<Fault> faults = VerdictWords.faults(verdict);
    PrintWriter out = spec.commandLine().getOut();
    List<VerdictWords.Joining> joining = VerdictWords.joining(verdict);
    if (json) {
      out.println(document(faults, joining, List.of()));
    } else {
      faults.forEach(fault -> out.println(fault.toString()));
      joining.forEach(
          device ->
              out.printf(
                  "%s could join, and would offer %s.%n",
                  device.device(),
                  device.features().isEmpty() ? "nothing" : String.join(", ", device.features())));
      out.println(faults.isEmpty() ? file + ": no fault." : count(faults));
    }
    return faults.isEmpty() ? ExitCode.DONE : ExitCode.NOT_REACHED;
  }

  private List<Words> found(String text) {
    Home joined = home.map(Shipped::home).orElseGet(CheckCommand::homeWithoutWords);
    return VerdictWords.contents(
            new DescriptionCheck(joined, DescriptionReader.of(joined)::read).check(text, file))
        .map(Words::of)
        .toList();
  }

  private static Home homeWithoutWords() {
    return new Home("", "", new HomeLoader().vocabulary(), Map.of(), Map.of());
  }

  private List<Words> asked(String text) {
    try (JoinedContainer container = platform.join()) {
      return Reply.lines(
          container.ask(
              ACLMessage.QUERY_REF,
              AgentNames.KNOWLEDGE,
              Words.content(
                  "query-ref",
                  Words.named("description", Words.text(text)),
                  Words.named("source", Words.text(file)))));
    }
  }

  private static String count(List<Fault> faults) {
    return faults.size() == 1 ? "1 fault." : faults.size() + " faults.";
  }

  private int checkHome() {
    PrintWriter out = spec.commandLine().getOut();
    try {
      Home loaded = Shipped.home(file);
      List<String> notes = new ArrayList<>(UnstatedNeeds.of(loaded));
      notes.addAll(ImpossibleUses.of(loaded));
      if (json) {
        out.println(document(List.of(), List.of(), notes));
      } else {
        notes.forEach(note -> out.println("Note: " + note));
        out.printf(
            "%s: no fault; %d devices, %d things in all.%n",
            file, loaded.devices().size(), loaded.individuals().size());
      }
      return ExitCode.DONE;
    } catch (HomeFaultException e) {
      if (json) {
        out.println(document(e.faults(), List.of(), List.of()));
      } else {
        e.faults().forEach(fault -> out.println(fault.toString()));
        out.println(count(e.faults()));
      }
      return ExitCode.NOT_REACHED;
    }
  }

  private String document(
      List<Fault> faults, List<VerdictWords.Joining> joining, List<String> notes) {
    JsonMembers document = JsonMembers.empty().text("file", file);
    ArrayNode array = document.node().putArray("faults");
    for (Fault fault : faults) {
      JsonMembers.in(array)
          .text("source", fault.source())
          .number("line", fault.line() > 0 ? OptionalInt.of(fault.line()) : OptionalInt.empty())
          .text("subject", fault.subject())
          .text("property", fault.property())
          .text("problem", fault.problem())
          .text("cure", fault.cure());
    }
    ArrayNode devices = document.node().putArray("could_join");
    joining.forEach(
        device ->
            JsonMembers.in(devices)
                .text("device", device.device())
                .words("features", device.features()));
    return document.words("notes", notes).toString();
  }
}
