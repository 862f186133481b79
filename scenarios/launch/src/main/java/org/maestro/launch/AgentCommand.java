package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.console.questions.AgentOrder;
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

    abstract AgentOrder order();

    @Override
    public Integer call() {
      AgentOrder order = order();
      try (AskedPlatform asked = platform.ask()) {
        JsonRows.of(
                asked.answer(questions -> questions.order(order)).path("told"), JsonNode::asText)
            .forEach(spec.commandLine().getOut()::println);
      }
      return ExitCode.DONE;
    }

    static String description(Path file) {
      try {
        return Files.readString(file);
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
      description = {
        "Start an agent for each device that a file describes, or one for all of them;",
        "and the agents of rooms and other groups that it describes."
      })
  static final class Add extends Request {
    @Parameters(
        paramLabel = "DEVICE.ttl",
        description = "Describes devices, or a room's agent and its devices, as a home file does.")
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
    AgentOrder order() {
      return new AgentOrder.Add(
          description(file), String.valueOf(file.getFileName()), as, container, needs);
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
    AgentOrder order() {
      return new AgentOrder.Move(agent, to);
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
    AgentOrder order() {
      return new AgentOrder.Reconfigure(
          agent, description(file), String.valueOf(file.getFileName()));
    }
  }

  @Command(
      name = "remove",
      description = "End an agent; its device gets no other until one is added.")
  static final class Remove extends Request {
    @Parameters(paramLabel = "ID", description = "The agent.")
    private String agent;

    @Override
    AgentOrder order() {
      return new AgentOrder.Remove(agent);
    }
  }
}
