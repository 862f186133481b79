package org.maestro.persons;

import java.util.Optional;
import org.maestro.ontology.home.PersonCue;
import org.maestro.sl.Formula;

/**
 * A cue as it may be told in this home.
 *
 * @param fact without variables
 * @param person of whom it speaks; empty: of somebody
 */
record CueSite(PersonCue cue, Formula.Atom fact, Optional<String> person, String zone) {}
