package org.maestro.knowledge.belief;

import java.util.List;
import org.maestro.ontology.home.Device;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * The reports of a device on itself: what it tells in each state, by its description, whenever it
 * is so.
 */
public record OwnReports(String device, List<Formula.Atom> templates) {

  public OwnReports(Device device) {
    this(
        device.id(),
        device.reports().values().stream()
            .map(SlParser::fact)
            .filter(Fact.Holds.class::isInstance)
            .map(fact -> ((Fact.Holds) fact).atom())
            .toList());
  }

  /** Whether a state without the ground atom says that it does not hold. */
  public boolean wouldTell(Formula.Atom atom) {
    return templates.stream().anyMatch(template -> fits(template, atom));
  }

  private boolean fits(Formula.Atom template, Formula.Atom atom) {
    boolean fits =
        template.predicate().equals(atom.predicate())
            && template.arguments().size() == atom.arguments().size();
    for (int n = 0; fits && n < atom.arguments().size(); n++) {
      fits = fits(template.arguments().get(n), atom.arguments().get(n));
    }
    return fits;
  }

  private boolean fits(Term template, Term value) {
    if (template instanceof Term.Variable variable) {
      return !variable.name().equals(Self.NAME) || value.equals(new Term.Name(device));
    }
    return template.equals(value);
  }
}
