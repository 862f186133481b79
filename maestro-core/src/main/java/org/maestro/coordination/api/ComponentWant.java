package org.maestro.coordination.api;

import java.util.Set;
import java.util.TreeSet;

/**
 * Parts of a member that a goal wants while another manager of goals has them (ADE, 6; A94).
 *
 * @param standing where in the order of all goals it stands, also of those of other managers
 * @param components of the member, by name; all of them at once or none
 */
public record ComponentWant(
    String goalId, GoalPriority standing, String member, Set<String> components) {
  public ComponentWant {
    components = Set.copyOf(components);
  }

  /** Its components as what goals contend for. */
  public Set<Resource> resources() {
    Set<Resource> resources = new TreeSet<>();
    components.forEach(component -> resources.add(Resource.component(member, component)));
    return resources;
  }
}
