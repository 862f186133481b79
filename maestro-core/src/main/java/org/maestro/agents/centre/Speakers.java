package org.maestro.agents.centre;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Caller;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.PersonalPermission;
import org.maestro.ontology.validation.Nearest;

/** The persons of the home on whose behalf goals are asked for. */
final class Speakers {
  private final Supplier<Home> home;

  Speakers(Supplier<Home> home) {
    this.home = home;
  }

  /**
   * On whose behalf a message asks. Who has signed in by a person's name asks for herself; else the
   * desk is believed, and on a site that is not secured everybody.
   *
   * @throws InvalidGoalException when nobody is called so, or it is not believed
   */
  Optional<String> of(Caller caller, Words words) {
    Optional<String> signedIn =
        caller.user().flatMap(user -> person(name -> name.equalsIgnoreCase(user)));
    Optional<String> said = words.string("speaker");
    if (signedIn.isPresent() || said.isEmpty()) {
      return signedIn;
    }
    if (!caller.agent().equals(AgentNames.DESK) && caller.user().isPresent()) {
      throw new InvalidGoalException(
          "%s is not believed to ask on behalf of %s; ask in the conversation of that person."
              .formatted(caller, said.get()));
    }
    return Optional.of(
        person(said.get()::equals)
            .orElseThrow(
                () ->
                    new InvalidGoalException(
                        "This home has no person %s; %s."
                            .formatted(
                                said.get(),
                                Nearest.cure(
                                    said.get(),
                                    names(),
                                    "it has " + String.join(", ", names()))))));
  }

  private Optional<String> person(Predicate<String> wanted) {
    return names().stream().filter(wanted).findFirst();
  }

  private List<String> names() {
    return home.get().individuals().values().stream()
        .filter(PersonalPermission::isPerson)
        .map(Individual::name)
        .toList();
  }
}
