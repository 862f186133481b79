package org.maestro.agents.content;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.Charge;
import org.maestro.deployment.ProcessStart;
import org.maestro.sl.Content;

/**
 * The wording of how an agent was started, as it travels to the container that is to have it:
 * {@code (start (:agent lamp-9) (:topic lights) (:container lights) (:charge (:member lamp-9)
 * (:description "...")))}.
 */
public final class StartWords {
  public static final String OPERATOR = "start";

  private StartWords() {}

  public static Content content(AgentStart start) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("agent", Words.name(start.agent())));
    arguments.add(Words.named("topic", Words.name(start.topic())));
    arguments.add(Words.named("container", Words.name(start.container())));
    if (!start.needs().isEmpty()) {
      arguments.add(Words.named("needs", start.needs().stream().map(Words::text).toList()));
    }
    arguments.addAll(charges(start.charges()));
    return new Content(OPERATOR, arguments);
  }

  /**
   * The name and the password that a person shows for an agent that she starts by hand.
   *
   * @param password in clear
   */
  public record Shown(String person, String password) {
    @Override
    public String toString() {
      return person;
    }
  }

  /** The same, said by an agent that was started by hand and wants to be taken in. */
  public static Content registration(AgentStart start, Optional<Shown> shown) {
    List<Content.Argument> arguments = new ArrayList<>(content(start).arguments());
    shown.ifPresent(
        its ->
            arguments.add(
                Words.named(
                    "shown",
                    Words.named("person", Words.text(its.person())),
                    Words.named("password", Words.text(its.password())))));
    return new Content(OPERATOR, arguments);
  }

  /** What a registration shows. */
  public static Optional<Shown> shown(Words words) {
    return words
        .find("shown")
        .map(its -> new Shown(its.string("person").orElse(""), its.string("password").orElse("")));
  }

  public static List<Content.Argument> charges(List<Charge> charges) {
    List<Content.Argument> arguments = new ArrayList<>();
    for (Charge charge : charges) {
      List<Content.Argument> parts = new ArrayList<>();
      parts.add(Words.named("member", Words.name(charge.member())));
      charge
          .description()
          .ifPresent(text -> parts.add(Words.named("description", Words.text(text))));
      arguments.add(Words.named("charge", parts));
    }
    return arguments;
  }

  /** What {@link #content} wrote. */
  public static AgentStart read(Words words) {
    String agent = words.string("agent").orElse("");
    String topic = words.string("topic").orElse("");
    return new AgentStart(
        agent, charges(words), topic, needs(words), words.string("container").orElse(topic));
  }

  /** How a process says that it was started. */
  public static Content.Argument.Named process(ProcessStart start) {
    return Words.named(
        "started",
        Words.named("machine", Words.text(start.machine())),
        Words.named("pid", Words.text(String.valueOf(start.pid()))),
        Words.named("directory", Words.text(start.directory())),
        Words.named("command", Words.text(start.command())));
  }

  public static ProcessStart process(Words words) {
    String pid = words.string("pid").filter(text -> text.matches("[0-9]{1,18}")).orElse("0");
    return new ProcessStart(
        words.string("machine").orElse(""),
        Long.parseLong(pid),
        words.string("directory").orElse(""),
        words.string("command").orElse(""));
  }

  static Set<String> needs(Words words) {
    Set<String> needs = new TreeSet<>();
    words.find("needs").ifPresent(w -> w.terms().forEach(term -> needs.add(Words.plain(term))));
    return needs;
  }

  public static List<Charge> charges(Words words) {
    List<Charge> charges = new ArrayList<>();
    for (Content.Argument.Named named : words.all()) {
      if (named.name().equals("charge")) {
        Words parts = Words.of(named);
        charges.add(new Charge(parts.string("member").orElse(""), parts.string("description")));
      }
    }
    return charges;
  }
}
