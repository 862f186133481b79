/**
 * The JUnit 5 extension: a test class names a home, a scene and a clock, and gets a platform and
 * the simulated world behind it on a stage. Annotations, goals and what people say flow in,
 * outcomes and assertions over goals, world and knowledge flow out. One embedded broker per JVM and
 * one site per class keep parallel classes apart. It knows no word of a domain.
 */
@NullMarked
package org.maestro.junit;

import org.jspecify.annotations.NullMarked;
