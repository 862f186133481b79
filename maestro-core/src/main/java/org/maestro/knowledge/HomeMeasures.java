package org.maestro.knowledge;

import java.util.List;
import java.util.OptionalDouble;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The geometry of a home. */
final class HomeMeasures implements Measures {

  HomeMeasures(Home home) {}

  @Override
  public boolean isNumber(String function) {
    return false;
  }

  @Override
  public boolean isTruth(String function) {
    return false;
  }

  @Override
  public OptionalDouble number(String function, List<Term> arguments, Snapshot snapshot) {
    return OptionalDouble.empty();
  }

  @Override
  public Truth truth(String function, List<Term> arguments, Snapshot snapshot) {
    return Truth.UNKNOWN;
  }
}
