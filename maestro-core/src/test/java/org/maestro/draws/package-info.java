/**
 * Random choices of property tests that jqwik can shrink: what {@code @ForAll Random} gives. A case
 * that fails is reported with fewer and smaller choices, and with the seed that brings it back.
 */
package org.maestro.draws;
