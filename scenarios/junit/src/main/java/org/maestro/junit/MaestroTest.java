package org.maestro.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Runs the tests of a class on a stage: a platform with all agents, and the simulated devices and
 * world behind it. A parameter of type {@link Stage} gets it. Each test method has a fresh one,
 * unless the class is {@link Shared}.
 */
@Documented
@Inherited
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
@ExtendWith(MaestroExtension.class)
public @interface MaestroTest {

  /**
   * Name of a shipped home ({@code bob}), or a resource of the test's class path that ends in
   * {@code .ttl}.
   */
  String home();

  /**
   * Name of a shipped scene ({@code bob-dark}), or a resource of the test's class path that ends in
   * {@code .ttl}.
   */
  String scene();

  ClockKind clock() default ClockKind.STEPPED;

  /** Seed of all randomness in the simulated world. */
  long seed() default 1;

  /** Simulated seconds per second of wall time; for a paced clock. */
  double speed() default 10;

  /** Simulated seconds after which waiting for a goal's end fails the test. */
  long patience() default 600;
}
