package org.maestro.knowledge.belief;

import java.time.Instant;
import java.util.Objects;
import java.util.Optional;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Term;

/**
 * The platform's beginning: since then counts what stood in the home at that time.
 *
 * @param home as its file states it
 */
public record Beginning(Instant at, Home home) {

  /** What stands in the home, whoever wrote it there. */
  Belief belief(String fact) {
    return new Belief(fact, new Source(Source.Kind.DESCRIBED, home.file().orElse(Source.HOME)), at);
  }

  /** The same, unless the thing is described otherwise by now, as devices do that join. */
  Optional<Belief> belief(String fact, Term subject, Home now) {
    return subject instanceof Term.Name name
            && Objects.equals(
                home.individuals().get(name.text()), now.individuals().get(name.text()))
        ? Optional.of(belief(fact))
        : Optional.empty();
  }
}
