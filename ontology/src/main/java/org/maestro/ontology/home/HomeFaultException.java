package org.maestro.ontology.home;

import java.util.List;
import org.maestro.ontology.validation.Fault;

/**
 * A vocabulary, home file or description has faults and is not used. The message is the first fault
 * and how many more there are.
 */
public final class HomeFaultException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final transient List<Fault> faults;

  /**
   * @param faults at least one
   */
  public HomeFaultException(List<Fault> faults) {
    super(
        faults.get(0)
            + (faults.size() > 1 ? " (and " + (faults.size() - 1) + " more faults)" : ""));
    this.faults = List.copyOf(faults);
  }

  /** All faults, in the order of the file. */
  public List<Fault> faults() {
    return faults;
  }
}
