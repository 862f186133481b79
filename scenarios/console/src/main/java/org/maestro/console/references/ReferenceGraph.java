package org.maestro.console.references;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.maestro.agents.content.AgentNames;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.PersonTracking;
import org.maestro.persons.Informants;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The components of a running platform, and which refers to which, as solid ovals and solid arrows
 * of the paper's figure (ADE, 3.3, 5 and figure 5; A39, A74). Who is gone is in it no more, and
 * neither is what pointed to him: of members only those count that are on the bus, of what tells
 * the tracker of persons only what is known on its word at the moment.
 */
public final class ReferenceGraph {
  private static final String READS = "reads what is known";
  private static final String CALLS = "calls";

  private final List<RunningAgent> agents;
  private final Home home;
  private final Snapshot facts;
  private final Map<String, Set<Faculty>> faculties = new TreeMap<>();
  private final Map<String, String> agentByMember = new TreeMap<>();
  private final List<Reference> references = new ArrayList<>();

  /**
   * The graph of one moment.
   *
   * @param agents the document that lists all agents
   * @param home as it is now
   */
  public ReferenceGraph(JsonNode agents, Home home, Snapshot facts) {
    this.agents = RunningAgent.of(agents);
    this.home = home;
    this.facts = facts;
    Faculties all = new Faculties(home);
    for (RunningAgent agent : this.agents) {
      Set<Faculty> own = all.of(agent);
      if (!own.isEmpty()) {
        faculties.put(agent.name(), own);
      }
      agent.members().forEach(member -> agentByMember.put(member, agent.name()));
    }
    ofCentre();
    home.groups().values().forEach(this::ofGroup);
    home.tracking().ifPresent(this::ofTracker);
    ofSupervisor();
  }

  /** In the order of the agents' list. */
  List<Component> components() {
    return agents.stream()
        .flatMap(
            agent ->
                faculties.getOrDefault(agent.name(), Set.of()).stream()
                    .map(faculty -> new Component(agent.name(), agent.container(), faculty)))
        .toList();
  }

  List<Reference> references() {
    return List.copyOf(references);
  }

  List<String> members(String agent) {
    return agents.stream()
        .filter(one -> one.name().equals(agent))
        .flatMap(one -> one.members().stream())
        .toList();
  }

  private void ofCentre() {
    String centre = AgentNames.COORDINATOR;
    refer(AgentNames.DESK, Faculty.LANGUAGE, centre, Faculty.LANGUAGE, "passes on what is said");
    refer(centre, Faculty.LANGUAGE, centre, Faculty.COGNITION, "states what is wanted");
    refer(centre, Faculty.REFLECTION, centre, Faculty.COGNITION, "tells why");
    refer(centre, Faculty.COGNITION, centre, Faculty.AFFECT, "shows moods");
    refer(centre, Faculty.COGNITION, AgentNames.KNOWLEDGE, Faculty.COGNITION, READS);
    call(centre, member -> true);
  }

  private void ofGroup(Group group) {
    String agent = group.id();
    refer(agent, Faculty.COGNITION, AgentNames.KNOWLEDGE, Faculty.COGNITION, READS);
    Evaluation evaluation = new Evaluation(facts);
    call(
        agent,
        member ->
            group.members().contains(member)
                || group
                    .memberWhen()
                    .filter(
                        condition ->
                            evaluation.truth(condition, Map.of("member", new Term.Name(member)))
                                == Truth.TRUE)
                    .isPresent());
    if (group.hearing().isPresent()) {
      ofListener(agent);
    }
    home.tracking()
        .filter(tracking -> speaksOfPersons(group, tracking))
        .ifPresent(
            tracking ->
                refer(
                    agent,
                    Faculty.COGNITION,
                    tracking.agent(),
                    Faculty.PERCEPTION,
                    "asks where persons are"));
  }

  /** What one room does not understand any other may; and each may be asked where somebody is. */
  private void ofListener(String agent) {
    boolean isLed = faculties.containsKey(AgentNames.COORDINATOR);
    refer(
        agent,
        Faculty.LANGUAGE,
        isLed ? AgentNames.COORDINATOR : agent,
        Faculty.COGNITION,
        "states what is wanted");
    home.groups().values().stream()
        .filter(other -> other.hearing().isPresent() && !other.id().equals(agent))
        .forEach(
            other ->
                refer(
                    agent,
                    Faculty.LANGUAGE,
                    other.id(),
                    Faculty.LANGUAGE,
                    "passes on what it does not understand"));
    home.tracking()
        .ifPresent(
            tracking ->
                refer(
                    agent,
                    Faculty.LANGUAGE,
                    tracking.agent(),
                    Faculty.PERCEPTION,
                    "asks where persons are"));
  }

  private static boolean speaksOfPersons(Group group, PersonTracking tracking) {
    return Stream.concat(group.pursues().stream(), group.memberWhen().stream())
        .map(SlPrinter::print)
        .anyMatch(
            formula ->
                told(tracking).anyMatch(atom -> formula.contains("(" + atom.predicate() + " ")));
  }

  private static Stream<Formula.Atom> told(PersonTracking tracking) {
    PersonTracking.Words words = tracking.words();
    return Stream.of(Optional.of(words.is()), words.probablyIs(), words.heading(), words.guest())
        .flatMap(Optional::stream);
  }

  private void ofTracker(PersonTracking tracking) {
    refer(
        tracking.agent(),
        Faculty.PERCEPTION,
        AgentNames.KNOWLEDGE,
        Faculty.COGNITION,
        "tells where persons are");
    Informants.of(home, tracking, facts)
        .forEach(
            (source, zones) ->
                refer(
                    tracking.agent(),
                    Faculty.PERCEPTION,
                    agentByMember.getOrDefault(source, source),
                    Faculty.PERCEPTION,
                    "watches " + String.join(", ", zones)));
  }

  private void ofSupervisor() {
    for (RunningAgent agent : agents) {
      faculties.getOrDefault(agent.name(), Set.of()).stream()
          .findFirst()
          .filter(faculty -> !agent.name().equals(AgentNames.SUPERVISOR))
          .ifPresent(
              faculty ->
                  refer(
                      AgentNames.SUPERVISOR,
                      Faculty.REFLECTION,
                      agent.name(),
                      faculty,
                      "sees to it that it lives"));
    }
  }

  /** All that those members do, by the agents that stand for them. */
  private void call(String caller, Predicate<String> isCalled) {
    Set<String> called = new TreeSet<>();
    agentByMember.forEach(
        (member, agent) -> {
          boolean canDo =
              Optional.ofNullable(home.devices().get(member))
                  .filter(device -> !device.features().isEmpty())
                  .isPresent();
          if (canDo && isCalled.test(member)) {
            called.add(agent);
          }
        });
    for (String agent : called) {
      faculties
          .getOrDefault(agent, Set.of())
          .forEach(faculty -> refer(caller, Faculty.COGNITION, agent, faculty, CALLS));
    }
  }

  private void refer(String from, Faculty as, String to, Faculty toIts, String purpose) {
    boolean areThere =
        faculties.getOrDefault(from, Set.of()).contains(as)
            && faculties.getOrDefault(to, Set.of()).contains(toIts);
    if (areThere) {
      references.add(new Reference(from + "/" + as.word(), to + "/" + toIts.word(), purpose));
    }
  }
}
