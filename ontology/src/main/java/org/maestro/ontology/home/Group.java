package org.maestro.ontology.home;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.sl.Formula;

/**
 * An agent that stands for several devices and has goals of its own (Three-layered architecture, 2
 * and 5.1; M15, M91).
 *
 * @param individual its name is the agent's name
 * @param container topic of the abstraction container it lives in
 * @param members ids of the devices stated by name
 * @param memberWhen every device of which this is known to be true is a member too; its variable is
 *     {@code ?member}
 * @param pursues its goals, with {@code ?self} for the group; one may be a script of the home
 * @param worth of each of its goals; a script without a benefit here has its own
 * @param plans whether its agent makes plans; else it carries out scripts of calls only
 * @param hearing what it hears of what is said, if it is a room agent
 */
public record Group(
    Individual individual,
    Optional<String> container,
    Set<String> members,
    Optional<Formula> memberWhen,
    List<Formula> pursues,
    StatedWorth worth,
    boolean plans,
    Optional<RoomHearing> hearing) {
  public Group {
    members = Collections.unmodifiableSet(new TreeSet<>(members));
    pursues = List.copyOf(pursues);
  }

  /** One that plans, hears nothing, and says nothing of what its goals are worth. */
  public Group(
      Individual individual,
      Optional<String> container,
      Set<String> members,
      Optional<Formula> memberWhen,
      List<Formula> pursues) {
    this(
        individual,
        container,
        members,
        memberWhen,
        pursues,
        StatedWorth.NONE,
        true,
        Optional.empty());
  }

  public String id() {
    return individual.name();
  }
}
