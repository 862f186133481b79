package org.maestro.launch;

import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.console.questions.Reply;
import org.maestro.platform.JoinedContainer;
import org.maestro.sl.Content;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Adds, moves, configures and removes agents of a running platform, by request to its CCA. */
@Command(
    name = "agent",
    description = "Add, move, reconfigure or remove an agent of a running platform.",
    subcommands = {
      AgentCommand.Add.class,
      AgentCommand.Move.class,
      AgentCommand.Reconfigure.class,
      AgentCommand.Remove.class
    })
final class AgentCommand implements Runnable {
  @Spec private CommandSpec spec;

  @Override
  public void run() {
    throw new ParameterException(
        spec.commandLine(), "Say what to do: agent add, move, reconfigure or remove.");
  }

  /** The common part of the four requests to the coordinator. */
  abstract static class Request implements Callable<Integer> {
    @Spec private CommandSpec spec;
    @Mixin private PlatformOptions platform;

    abstract List<Content.Argument> arguments();

    @Override
    public Integer call() {
      List<Content.Argument> all = new ArrayList<>();
      all.add(Words.named("action", Words.name(spec.name())));
      all.addAll(arguments());
      try (JoinedContainer container = platform.join()) {
        Reply.lines(
                container.ask(
                    ACLMessage.REQUEST, AgentNames.COORDINATOR, new Content("perform", all)))
            .forEach(line -> spec.commandLine().getOut().println(line.string("text").orElse("")));
      }
      return ExitCode.DONE;
    }

    static List<Content.Argument> description(Path file) {
      try {
        return List.of(
            Words.named("description", Words.text(Files.readString(file))),
            Words.named("file", Words.text(String.valueOf(file.getFileName()))));
      } catch (IOException e) {
        throw CommandException.badInput(
            "There is no device file "
                + file
                + " that can be read; give the path of a Turtle file.");
      }
    }
  }

  @Command(
      name = "add",
      description = "Start an agent for each device that a file describes, or one for all of them.")
  static final class Add extends Request {
    @Parameters(
        paramLabel = "DEVICE.ttl",
        description = "Describes one device or several, as a home file does.")
    private Path file;

    @Option(
        names = "--as",
        paramLabel = "ID",
        description = "One agent of that name for all devices of the file.")
    private Optional<String> as;

    @Option(
        names = "--container",
        paramLabel = "NAME",
        description = "Where; without: where its topic (maestro:container) lives.")
    private Optional<String> container;

    @Option(
        names = "--needs",
        paramLabel = "WHAT",
        split = ",",
        description = "What its host has to provide, such as microphone.")
    private List<String> needs = List.of();

    @Override
    List<Content.Argument> arguments() {
      List<Content.Argument> arguments = new ArrayList<>(description(file));
      as.ifPresent(name -> arguments.add(Words.named("as", Words.text(name))));
      container.ifPresent(name -> arguments.add(Words.named("container", Words.text(name))));
      if (!needs.isEmpty()) {
        arguments.add(Words.named("needs", needs.stream().map(Words::text).toList()));
      }
      return arguments;
    }
  }

  @Command(
      name = "move",
      description = "Have an agent live in another container; it goes when nothing is under way.")
  static final class Move extends Request {
    @Parameters(paramLabel = "ID", description = "The agent.")
    private String agent;

    @Option(
        names = "--to",
        paramLabel = "CONTAINER",
        required = true,
        description = "One that ./maestro agents --containers lists.")
    private String to;

    @Override
    List<Content.Argument> arguments() {
      return List.of(Words.named("agent", Words.text(agent)), Words.named("to", Words.text(to)));
    }
  }

  @Command(
      name = "reconfigure",
      description = "Have an agent go by another description of its device.")
  static final class Reconfigure extends Request {
    @Parameters(index = "0", paramLabel = "ID", description = "The agent.")
    private String agent;

    @Parameters(index = "1", paramLabel = "FILE", description = "Describes its device anew.")
    private Path file;

    @Override
    List<Content.Argument> arguments() {
      List<Content.Argument> arguments = new ArrayList<>(description(file));
      arguments.add(Words.named("agent", Words.text(agent)));
      return arguments;
    }
  }

  @Command(
      name = "remove",
      description = "End an agent; its device gets no other until one is added.")
  static final class Remove extends Request {
    @Parameters(paramLabel = "ID", description = "The agent.")
    private String agent;

    @Override
    List<Content.Argument> arguments() {
      return List.of(Words.named("agent", Words.text(agent)));
    }
  }
}
