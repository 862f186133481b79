/**
 * What persons may have done in a home, held against what they ask for. A home with its permissions
 * of persons, a person and a goal flow in; the home as it is for that person, and the reason why
 * something is not done for her, flow out. Knows neither plans nor agents: whoever plans does so in
 * the home as it is for the person.
 */
@NullMarked
package org.maestro.ontology.permission;

import org.jspecify.annotations.NullMarked;
