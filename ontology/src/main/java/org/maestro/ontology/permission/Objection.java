package org.maestro.ontology.permission;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;

/**
 * Why something is not done for somebody.
 *
 * @param person who asks; empty: nobody who is known
 * @param way what would have to be done
 * @param limit how far she may go with it; empty: she may not at all
 * @param others names of the persons for whom it may be done, in order
 * @param permissions names of the permissions that say so
 */
public record Objection(
    Optional<String> person,
    Way way,
    Optional<Limit> limit,
    List<String> others,
    Set<String> permissions) {
  public Objection {
    others = List.copyOf(others);
    permissions = new TreeSet<>(permissions);
  }

  /**
   * A number beyond which somebody may not go.
   *
   * @param what is set
   * @param relation of what may be to the number: at most, less than, at least, more than, exactly
   */
  public record Limit(Expression.Fluent what, Formula.Relation relation, double number) {}
}
