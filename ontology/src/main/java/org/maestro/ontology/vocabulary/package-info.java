/**
 * The typed read model of the vocabulary: classes, predicates and fluents, feature types. Turtle
 * flows in through the loader, immutable records flow out to knowledge, planning and members. It
 * may not know any word of a particular domain.
 */
@NullMarked
package org.maestro.ontology.vocabulary;

import org.jspecify.annotations.NullMarked;
