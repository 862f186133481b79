/**
 * What others want of the central agent about goals, their ends and stories, and what it tells of
 * the goals of others. Requests and entries of stories flow in; answers flow out. It decides
 * nothing about a goal's course.
 */
@NullMarked
package org.maestro.agents.centre;

import org.jspecify.annotations.NullMarked;
