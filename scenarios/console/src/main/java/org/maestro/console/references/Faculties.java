package org.maestro.console.references;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.agents.content.AgentNames;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Body;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/**
 * What each agent of a home is for: that of its own agents follows from their place in the
 * platform, that of all others from what the home says of their groups and devices.
 */
final class Faculties {
  /** Classes of where one can be. */
  private static final Set<String> PLACES = Set.of("Place", "Location", "Zone");

  private final Home home;

  Faculties(Home home) {
    this.home = home;
  }

  Set<Faculty> of(RunningAgent agent) {
    Optional<Group> group = Optional.ofNullable(home.groups().get(agent.name()));
    if (group.isPresent()) {
      return group.get().hearing().isPresent()
          ? EnumSet.of(Faculty.COGNITION, Faculty.LANGUAGE)
          : EnumSet.of(Faculty.COGNITION);
    }
    if (home.tracking().filter(tracking -> tracking.agent().equals(agent.name())).isPresent()) {
      return EnumSet.of(Faculty.PERCEPTION);
    }
    return switch (agent.name()) {
      case AgentNames.COORDINATOR -> ofCoordinator();
      case AgentNames.KNOWLEDGE -> EnumSet.of(Faculty.COGNITION);
      case AgentNames.SUPERVISOR -> EnumSet.of(Faculty.REFLECTION);
      case AgentNames.DESK -> EnumSet.of(Faculty.LANGUAGE);
      default ->
          agent.hasMembers()
              ? agent.members().stream()
                  .flatMap(member -> Optional.ofNullable(home.devices().get(member)).stream())
                  .flatMap(device -> ofDevice(device).stream())
                  .collect(Collectors.toCollection(() -> EnumSet.noneOf(Faculty.class)))
              : EnumSet.noneOf(Faculty.class);
    };
  }

  private Set<Faculty> ofCoordinator() {
    Set<Faculty> all = EnumSet.of(Faculty.COGNITION, Faculty.REFLECTION, Faculty.LANGUAGE);
    if (home.scripts().values().stream().anyMatch(script -> showsAMood(script.body()))) {
      all.add(Faculty.AFFECT);
    }
    return all;
  }

  private static boolean showsAMood(Body body) {
    return body instanceof Body.Express || body.parts().stream().anyMatch(Faculties::showsAMood);
  }

  private static Set<Faculty> ofDevice(Device device) {
    Set<Faculty> all = EnumSet.noneOf(Faculty.class);
    Set<String> endings =
        device.features().stream()
            .flatMap(feature -> feature.endedBy().stream())
            .collect(Collectors.toSet());
    device.features().stream()
        .filter(feature -> !endings.contains(feature.name()))
        .map(Faculties::of)
        .forEach(all::add);
    if (device.features().isEmpty() && !device.reports().isEmpty()) {
      all.add(Faculty.PERCEPTION);
    }
    return all;
  }

  private static Faculty of(FeatureType feature) {
    if (feature.learns().isPresent() || senses(feature.effect())) {
      return Faculty.PERCEPTION;
    }
    return added(feature.effect()).anyMatch(atom -> isOwnPlace(atom, feature))
        ? Faculty.NAVIGATION
        : Faculty.ACTION;
  }

  private static boolean senses(Effect effect) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().anyMatch(Faculties::senses);
    }
    return effect instanceof Effect.SenseAtom || effect instanceof Effect.SenseNumber;
  }

  private static Stream<Formula.Atom> added(Effect effect) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().flatMap(Faculties::added);
    }
    return effect instanceof Effect.Add add ? Stream.of(add.atom()) : Stream.empty();
  }

  /** Whether it says in which of the places that the feature is given the member then is. */
  private static boolean isOwnPlace(Formula.Atom atom, FeatureType feature) {
    List<Term> terms = atom.arguments();
    return terms.size() == 2
        && terms.get(0).equals(Self.VARIABLE)
        && Stream.concat(feature.inputs().stream(), feature.binds().stream())
            .filter(parameter -> terms.get(1).equals(new Term.Variable(parameter.name())))
            .map(Parameter::types)
            .anyMatch(types -> types.stream().anyMatch(PLACES::contains));
  }
}
