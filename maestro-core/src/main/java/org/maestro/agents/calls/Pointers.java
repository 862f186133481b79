package org.maestro.agents.calls;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallArguments;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Content;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/**
 * Completes orders of agents that name things by their names alone: what a member needs to know of
 * them is asked of the knowledge agent (Three-layered architecture, 3.2.3; M58).
 *
 * <pre>
 * (query-ref (:call (:member cam-1) (:feature observeObject) (:parameters (:object Cup))))
 * (inform (:parameters (:object Cup (:iri "...") (:colour red))))
 * </pre>
 */
public final class Pointers {
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);

  private final MaestroAgent agent;
  private final String member;

  Pointers(MaestroAgent agent, String member) {
    this.agent = agent;
    this.member = member;
  }

  /** Whether a parameter names something of which the member needs to know more. */
  static boolean areMissing(FeatureType feature, Map<String, Argument> arguments) {
    return parameters(feature)
        .anyMatch(
            parameter ->
                Optional.ofNullable(arguments.get(parameter.name()))
                    .filter(a -> a.iri().isEmpty() && a.value() instanceof Term.Name)
                    .filter(a -> !parameter.oneOf().contains(a.value()))
                    .isPresent());
  }

  private static Stream<Parameter> parameters(FeatureType feature) {
    return Stream.concat(feature.inputs().stream(), feature.binds().stream());
  }

  /**
   * @param completed told the arguments with what belongs to them
   * @param refused told one sentence instead
   */
  void complete(
      FeatureType feature,
      Map<String, Argument> arguments,
      Consumer<Map<String, Argument>> completed,
      Consumer<String> refused) {
    Content question =
        Words.content(
            "query-ref",
            Words.named(
                "call",
                Words.named("member", Words.name(member)),
                Words.named("feature", Words.name(feature.name())),
                Orders.parameters("parameters", arguments)));
    agent.ask(
        agent.message(ACLMessage.QUERY_REF, agent.getAID(AgentNames.KNOWLEDGE), question),
        ANSWER_WITHIN,
        reply -> read(reply, arguments, completed, refused));
  }

  private static void read(
      ACLMessage reply,
      Map<String, Argument> arguments,
      Consumer<Map<String, Argument>> completed,
      Consumer<String> refused) {
    try {
      if (reply.getPerformative() != ACLMessage.INFORM) {
        refused.accept(
            Replies.reason(reply).orElse("The knowledge agent does not answer; ask again later."));
        return;
      }
      Map<String, Argument> all = new TreeMap<>(arguments);
      for (Content content : Words.parse(reply.getContent())) {
        Words.of(content)
            .find("parameters")
            .ifPresent(words -> all.putAll(Orders.arguments(words)));
      }
      completed.accept(all);
    } catch (SlSyntaxException e) {
      refused.accept("The knowledge agent answers unreadably: " + e.getMessage());
    }
  }

  /**
   * The knowledge agent's side: what is known of the things that a call names.
   *
   * @param rights of who asks
   * @throws UnknownThing with one sentence
   */
  public static Content answer(KnowledgeBase knowledge, Words call, ReadingRights rights) {
    Home home = knowledge.home();
    Snapshot now = knowledge.snapshot();
    String feature = call.string("feature").orElse("");
    Map<String, Argument> named = call.find("parameters").map(Orders::arguments).orElse(Map.of());
    Optional<FeatureType> type =
        Optional.ofNullable(home.devices().get(call.string("member").orElse(""))).stream()
            .map(Device::features)
            .flatMap(List::stream)
            .filter(f -> f.name().equals(feature))
            .findFirst();
    if (type.isEmpty()) {
      throw new UnknownThing("The feature " + Replies.shortened(feature) + " is not known here.");
    }
    Set<String> needs =
        parameters(type.get())
            .flatMap(parameter -> parameter.needs().stream())
            .collect(Collectors.toSet());
    rights
        .objection(needs)
        .ifPresent(
            sentence -> {
              throw new UnknownThing(sentence);
            });
    Map<String, Term> bindings = new TreeMap<>();
    named.forEach((name, argument) -> bindings.put(name, argument.value()));
    parameters(type.get())
        .filter(parameter -> !parameter.needs().isEmpty())
        .forEach(parameter -> requireKnown(home, parameter, bindings));
    return Words.content(
        "inform",
        Orders.parameters("parameters", new CallArguments(home, now).of(type.get(), bindings)));
  }

  private static void requireKnown(Home home, Parameter parameter, Map<String, Term> bindings) {
    if (bindings.get(parameter.name()) instanceof Term.Name name
        && !home.individuals().containsKey(name.text())) {
      throw new UnknownThing(
          "Nothing named %s is known for the parameter %s; name a %s of this home."
              .formatted(
                  Replies.shortened(name.text()),
                  parameter.name(),
                  String.join(" or ", parameter.types())));
    }
  }

  /**
   * A call names what nobody here has heard of, or needs what who asks may not read; the message is
   * one sentence.
   */
  public static final class UnknownThing extends RuntimeException {
    private static final long serialVersionUID = 1L;

    UnknownThing(String message) {
      super(message);
    }
  }
}
