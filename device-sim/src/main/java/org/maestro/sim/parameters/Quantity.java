package org.maestro.sim.parameters;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The meaning of a number of the simulated world, its unit, and from where its usual value comes:
 * who sets it, and who reads what an experiment found, is told all three.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Quantity {
  String meaning();

  /** 1 for a share or another number without one. */
  String unit();

  /** A data sheet, a paper or a standard, or that it is assumed. */
  String source();
}
