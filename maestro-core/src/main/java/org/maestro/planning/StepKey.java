package org.maestro.planning;

import java.util.Map;
import org.maestro.sl.Term;

/** A feature instance: who does what with which inputs and bindings. */
public record StepKey(String member, String feature, Map<String, Term> bindings) {}
