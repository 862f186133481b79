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
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.questions.Reply;
import org.maestro.ontology.home.CheckedHome;
import org.maestro.ontology.home.DescriptionCheck;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeFaultException;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.validation.Fault;
import org.maestro.platform.JoinedContainer;
import org.maestro.sim.scene.CheckedScene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Reads a home file with its scene, or what a device says of itself, and tells the faults. */
@Command(
    name = "check",
    description =
        "Tell every fault of a home file, of a scene, or of a device's description, with its place and"
            + " cure.")
final class CheckCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private PlatformOptions platform;

  @Parameters(
      paramLabel = "FILE",
      completionCandidates = Shipped.Homes.class,
      description =
          "A home file, or a shipped home: bob, arena; or a description in JSON-LD, FILE.json or"
              + " FILE.jsonld, as a device sends it.")
  private String file;

  @Option(
      names = "--home",
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      description = "The home that the described device is to join; without: one without words.")
  private Optional<String> home = Optional.empty();

  @Option(
      names = "--scene",
      paramLabel = "SCENE.ttl",
      completionCandidates = Shipped.Scenes.class,
      description = "Check this scene of the home as well: a file, or a shipped one.")
  private Optional<String> scene = Optional.empty();

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
    if (scene.isPresent()) {
      throw CommandException.badInput("--scene goes with a home file; leave it away.");
    }
    if (home.isPresent() && running) {
      throw CommandException.badInput("--home and --running exclude each other; leave one away.");
    }
    String text = Shipped.read(Shipped.file(file, "description", List.of()));
    List<Words> verdict = running ? asked(text) : found(text);
    List<Fault> faults = VerdictWords.faults(verdict);
    List<Fault> warnings = VerdictWords.warnings(verdict);
    PrintWriter out = spec.commandLine().getOut();
    List<VerdictWords.Joining> joining = VerdictWords.joining(verdict);
    if (json) {
      out.println(document(faults, warnings, joining));
    } else {
      tell(faults, warnings);
      joining.forEach(
          device ->
              out.printf(
                  "%s could join, and would offer %s.%n",
                  device.device(),
                  device.features().isEmpty() ? "nothing" : String.join(", ", device.features())));
      out.println(sum(faults, warnings, Optional.empty()));
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

  private int checkHome() {
    List<Fault> faults = new ArrayList<>();
    List<Fault> warnings = new ArrayList<>();
    Optional<Home> read = Optional.empty();
    try {
      CheckedHome checked = Shipped.checkedHome(file);
      warnings.addAll(checked.warnings());
      read = Optional.of(checked.home());
      if (scene.isPresent()) {
        CheckedScene ofScene = Shipped.checkedScene(scene.get(), checked.home());
        faults.addAll(ofScene.faults());
        warnings.addAll(ofScene.warnings());
      }
    } catch (HomeFaultException e) {
      faults.addAll(e.faults());
    }
    if (json) {
      spec.commandLine().getOut().println(document(faults, warnings, List.of()));
    } else {
      tell(faults, warnings);
      spec.commandLine().getOut().println(sum(faults, warnings, read));
    }
    return faults.isEmpty() ? ExitCode.DONE : ExitCode.NOT_REACHED;
  }

  private String sum(List<Fault> faults, List<Fault> warnings, Optional<Home> read) {
    String counted =
        (faults.isEmpty() ? file + ": no fault" : count(faults, "fault"))
            + (warnings.isEmpty() ? "" : ", " + count(warnings, "warning"));
    return read.filter(home -> faults.isEmpty())
        .map(
            home ->
                "%s; %d devices, %d things in all."
                    .formatted(counted, home.devices().size(), home.individuals().size()))
        .orElse(counted + ".");
  }

  private void tell(List<Fault> faults, List<Fault> warnings) {
    PrintWriter out = spec.commandLine().getOut();
    faults.forEach(fault -> out.println(fault.toString()));
    warnings.forEach(warning -> out.println("Warning: " + warning));
  }

  private static String count(List<Fault> told, String kind) {
    return told.size() + " " + kind + (told.size() == 1 ? "" : "s");
  }

  private String document(
      List<Fault> faults, List<Fault> warnings, List<VerdictWords.Joining> joining) {
    JsonMembers document = JsonMembers.empty().text("file", file);
    add(document.node().putArray("faults"), faults);
    add(document.node().putArray("warnings"), warnings);
    ArrayNode devices = document.node().putArray("could_join");
    joining.forEach(
        device ->
            JsonMembers.in(devices)
                .text("device", device.device())
                .words("features", device.features()));
    return document.toString();
  }

  private static void add(ArrayNode array, List<Fault> told) {
    for (Fault fault : told) {
      JsonMembers.in(array)
          .text("source", fault.source())
          .number("line", fault.line() > 0 ? OptionalInt.of(fault.line()) : OptionalInt.empty())
          .text("subject", fault.subject())
          .text("property", fault.property())
          .text("problem", fault.problem())
          .text("cure", fault.cure());
    }
  }
}
