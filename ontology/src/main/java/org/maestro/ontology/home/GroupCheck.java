package org.maestro.ontology.home;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.sl.Body;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;

/** Checks what group agents say of scripts and of worth, once all of the home is read. */
final class GroupCheck {
  private static final Node PURSUES = Maestro.term("pursues");
  private static final Map<String, List<String>> THE_GROUP =
      Map.of(Self.NAME, List.of("GroupAgent"));

  private final SourceGraph graph;
  private final Home home;

  GroupCheck(SourceGraph graph, Home home) {
    this.graph = graph;
    this.home = home;
  }

  void check(Map<String, Node> nodes) {
    if (home.groups().isEmpty()) {
      return;
    }
    Offers offers = new Offers(graph, home);
    checkHearing(nodes);
    home.groups().forEach((name, group) -> check(HomeCheck.named(nodes, name), group, offers));
  }

  private void check(Node node, Group group, Offers offers) {
    BodyCheck ofBenefit =
        new BodyCheck(
            home, offers, (problem, cure) -> fault(node, Maestro.term("benefit"), problem, cure));
    group.worth().benefit().ifPresent(benefit -> ofBenefit.names(THE_GROUP).check(benefit));
    BodyCheck ofGoals =
        new BodyCheck(home, offers, (problem, cure) -> fault(node, PURSUES, problem, cure));
    for (Formula goal : group.pursues()) {
      Optional<Script> script = script(goal);
      script.ifPresent(
          found ->
              ofGoals.check(
                  new Body.Run(found.name(), ((Formula.Atom) goal).arguments()), THE_GROUP));
      if (!group.plans()) {
        checkThatNothingIsPlanned(node, script);
      }
    }
  }

  /** That what room agents understand is there, and that a room is heard by one of them only. */
  private void checkHearing(Map<String, Node> nodes) {
    Set<String> known = new TreeSet<>(home.wording().topics().keySet());
    home.wording().constructions().forEach(one -> known.add(one.name()));
    Map<String, String> agentByRoom = new HashMap<>();
    for (Group group : home.groups().values()) {
      Node node = HomeCheck.named(nodes, group.id());
      Set<String> topics = group.hearing().map(RoomHearing::topics).orElse(Set.of());
      topics.stream()
          .filter(topic -> !known.contains(topic))
          .forEach(
              topic ->
                  fault(
                      node,
                      Maestro.term("understands"),
                      "names %s, which is neither a topic nor a construction".formatted(topic),
                      Nearest.cure(topic, known, "declare it as a maestro:Topic")));
      for (String room : group.hearing().map(RoomHearing::rooms).orElse(Set.of())) {
        String other = agentByRoom.putIfAbsent(room, group.id());
        if (other != null) {
          fault(
              node,
              Maestro.term("hears"),
              "names %s, in which %s hears what is said".formatted(room, other),
              "keep one of both");
        }
      }
    }
  }

  private Optional<Script> script(Formula goal) {
    return goal instanceof Formula.Atom atom
        ? Optional.ofNullable(home.scripts().get(atom.predicate()))
        : Optional.empty();
  }

  private void checkThatNothingIsPlanned(Node node, Optional<Script> script) {
    if (script.isEmpty()) {
      fault(
          node,
          PURSUES,
          "states a goal that is to be planned for, and its agent makes no plans (maestro:plans"
              + " false)",
          "name a script, or leave maestro:plans out");
    } else if (achieves(script.get().body(), new LinkedHashSet<>())) {
      fault(
          node,
          PURSUES,
          "runs %s, which achieves something by a plan, and its agent makes none (maestro:plans"
                  .formatted(script.get().name())
              + " false)",
          "write its steps with do, or leave maestro:plans out");
    }
  }

  /** Whether a step of it, or of a script that it runs, is planned. */
  private boolean achieves(Body body, Set<String> seen) {
    if (body instanceof Body.Achieve || body instanceof Body.Look) {
      return true;
    }
    Optional<Body.Run> run =
        body instanceof Body.Run one
            ? Optional.of(one)
            : body instanceof Body.Let let && let.source() instanceof Body.Run source
                ? Optional.of(source)
                : Optional.empty();
    return run.map(Body.Run::script)
            .filter(seen::add)
            .map(home.scripts()::get)
            .filter(script -> achieves(script.body(), seen))
            .isPresent()
        || body.parts().stream().anyMatch(part -> achieves(part, seen));
  }

  private void fault(Node node, Node property, String problem, String cure) {
    graph.fault(node, property, Optional.empty(), problem, cure);
  }
}
